//! A symmetric matrix given with all its terms becomes its lower triangle, which is what is stored.

use model::Expression;
use schema::{Field, SYMMETRY_TOLERANCE, lower_triangle, place_by_columns, triangle_places};
use syntax::command::Argument;
use text::Diagnostic;

/// The terms of the lower triangle, and their expressions if there are any.
type Triangle = (Vec<f64>, Vec<Option<Expression>>);

/// The numbers and expressions to store of a field that may be given as a full matrix; as they are
/// if they are no full matrix.
pub fn folded(
    field: &Field,
    argument: &Argument,
    values: &[f64],
    elements: &[Option<Expression>],
) -> Result<Option<Triangle>, Diagnostic> {
    let Some(side) = field.symmetric.filter(|side| values.len() == side * side) else { return Ok(None) };
    let numbers = lower_triangle(values, side).map_err(|pair| {
        let of = |index: usize| {
            let (row, column) = place_by_columns(index, side);
            (values.get(index).copied().unwrap_or_default(), format!("row {row}, column {column}"))
        };
        let ((low, low_place), (high, high_place)) = (of(pair.below), of(pair.above));
        let error = Diagnostic::error(
            "value/not-symmetric",
            format!(
                "`{}` is not symmetric: {high} in {high_place} (term {}) is not {low} in {low_place} (term {})",
                field.name,
                pair.above + 1,
                pair.below + 1
            ),
        )
        .note(format!(
            "terms are counted by columns; two across the diagonal may differ by {SYMMETRY_TOLERANCE:e} of the larger one"
        ))
        .help(format!("make both equal, or give the {} terms of the lower triangle by columns", field.count.least))
        .adams(format!("{} values are required for '{}'.", field.count.least, field.name));
        match (argument.values.get(pair.above), argument.values.get(pair.below)) {
            (Some(high), Some(low)) if argument.values.len() == values.len() => {
                error.at(high.span, high_place).label(low.span, low_place)
            }
            _ => error.at(argument.value_span, "not symmetric"),
        }
    })?;
    // An expression on either side of the diagonal is kept: both have the same value.
    let mut kept = Vec::new();
    if elements.len() == values.len() {
        kept = triangle_places(side)
            .map(|(below, above)| {
                elements.get(below).cloned().flatten().or_else(|| elements.get(above).cloned().flatten())
            })
            .collect();
    }
    Ok(Some((numbers, kept)))
}
