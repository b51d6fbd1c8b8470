//! Expressions that mean something else in other units: those with bare numbers where a length, an
//! angle or another quantity is wanted.

use model::{CellKey, Database};

use crate::cells::{cell_name, compute};

/// Numbers that agree to this much of their size are the same: units are converted with rounding.
const SAME: f64 = 1e-9;

/// Names of the cells whose expressions do not yield any more what is stored: asked for after the
/// units or the sequence of angles were changed, before anything is evaluated again.
pub fn with_another_meaning(database: &Database) -> Vec<String> {
    let mut found = Vec::new();
    for id in database.ids() {
        for (index, cell) in database.object(id).cells.iter().filter(|(_, cell)| cell.is_expression()) {
            let field = database.field(id, index);
            let key = CellKey::new(id, index);
            let Ok(now) = compute(database, key, &cell.source) else { continue };
            let (Some(now), Some(stored)) = (now.value.as_numbers(), cell.value.as_numbers()) else { continue };
            let ratio = database.ratio(cell.units, field.dimension);
            let differs = |(now, stored): (&f64, &f64)| {
                let stored = stored * ratio;
                (now - stored).abs() > SAME * now.abs().max(stored.abs()).max(f64::MIN_POSITIVE)
            };
            if now.iter().zip(&stored).any(differs) {
                found.push(cell_name(database, key));
            }
        }
    }
    found
}
