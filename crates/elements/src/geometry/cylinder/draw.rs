//! Cells of a cylinder to its shape.

use std::f64::consts::TAU;

use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// A cylinder from the centre marker along its z; a negative length goes the other way.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("center_marker")?;
    let radius = cells.radius(&on)?;
    let shape = Shape::Frustum {
        bottom: radius,
        top: radius,
        length: cells.not_zero("length")?,
        angle: cells.angle("angle_extent", TAU)?,
        sides: cells.sides("side_count_for_body")?,
    };
    Ok(Placed { on, shape })
}
