//! Cells of a block to its shape.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// A box from the corner marker to the opposite corner; coordinates may be negative.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let corner = match database.si_numbers(id, "diag_corner_coords").as_deref() {
        Some(&[x, y, z]) => DVec3::new(x, y, z),
        Some(&[a]) => DVec3::splat(a),
        _ => DVec3::splat(database.units().length.si),
    };
    if !corner.is_finite() || corner.abs().min_element() == 0.0 {
        return Err(cells.trouble("geometry/degenerate", "has an edge of length zero or one that is not finite"));
    }
    Ok(Placed { on: cells.frame("corner_marker")?, shape: Shape::Block { corner } })
}
