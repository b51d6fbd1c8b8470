//! Cells of a frustum to its shape.

use std::f64::consts::TAU;

use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// A cut cone from the centre marker along its z; one radius may be zero.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let (bottom, top) = (cells.number("bottom_radius")?, cells.number("top_radius")?);
    if bottom < 0.0 || top < 0.0 || bottom + top == 0.0 {
        return Err(cells.trouble("geometry/not-positive", "needs radii of at least zero, one of them above zero"));
    }
    let shape = Shape::Frustum {
        bottom,
        top,
        length: cells.not_zero("length")?,
        angle: cells.angle("angle_extent", TAU)?,
        sides: cells.sides("side_count_for_body")?,
    };
    Ok(Placed { on: cells.frame("center_marker")?, shape })
}
