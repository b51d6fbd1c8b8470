//! Cells of a polyline to its line.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::Placed,
    place::{Cells, on_body},
    shape::Shape,
};

/// The points in the axes of the body, joined; the last one with the first if the line is closed.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = on_body(database, id).ok_or_else(|| cells.trouble("geometry/no-body", "is on no body"))?;
    let numbers = database.si_numbers(id, "location").unwrap_or_default();
    let triples = numbers.chunks_exact(3);
    if numbers.is_empty() || !numbers.len().is_multiple_of(3) || numbers.iter().any(|x| !x.is_finite()) {
        return Err(
            cells.trouble("geometry/missing-value", "needs a `location` of three finite coordinates for each point")
        );
    }
    let mut points: Vec<DVec3> = triples.map(DVec3::from_slice).collect();
    if database.flag(id, "close") == Some(true) {
        points.push(points[0]);
    }
    Ok(Placed { on, shape: Shape::Lines(vec![points]) })
}
