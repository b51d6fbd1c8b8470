//! Cells of a circle to its line.

use std::f64::consts::TAU;

use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::{Placed, arc_points},
    place::Cells,
    shape::Shape,
};

/// A circle around z of the centre marker.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("center_marker")?;
    let points = arc_points(cells.radius(&on)?, TAU, cells.sides("segment_count")?);
    Ok(Placed { on, shape: Shape::Lines(vec![points]) })
}
