//! Cells of a link to its shape.

use glam::{DVec2, DVec3};
use model::{Database, ObjectId, Pose};
use text::Diagnostic;

use crate::{
    geometry::{Placed, round_outline},
    place::{Cells, OnBody, axes},
    shape::Shape,
};

/// A bar in the plane across z of the first marker, from marker to marker.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let (i, j) = (cells.frame("i_marker")?, cells.frame("j_marker")?);
    let (width, depth) = (cells.above_zero("width")?, cells.above_zero("depth")?);
    let j_in_i = cells.relative(&i, &j).origin;
    let length = j_in_i.length();
    let Some(turn) = axes(j_in_i, DVec3::Z) else {
        return Err(cells.trouble("geometry/degenerate", "has its markers at one place, or one above the other"));
    };
    let ends = [DVec2::ZERO, DVec2::new(length, 0.0)];
    let shape = Shape::Plate { outline: round_outline(&ends, width / 2.0), thickness: depth };
    let local = Pose { origin: DVec3::ZERO, rotation: turn };
    Ok(Placed { on: OnBody { body: i.body, pose: i.pose.then(&local) }, shape })
}
