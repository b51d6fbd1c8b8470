//! Cells of a plane to its border.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// The border of the rectangle.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("ref_marker_name")?;
    let (left, right) = (cells.number("x_minimum")?, cells.number("x_maximum")?);
    let (low, high) = (cells.number("y_minimum")?, cells.number("y_maximum")?);
    let corners = [(left, low), (right, low), (right, high), (left, high), (left, low)];
    let border = corners.iter().map(|(x, y)| DVec3::new(*x, *y, 0.0)).collect();
    Ok(Placed { on, shape: Shape::Lines(vec![border]) })
}
