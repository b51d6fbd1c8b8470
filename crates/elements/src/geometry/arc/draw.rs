//! Cells of an arc to its line.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::{Placed, arc_points},
    place::Cells,
    shape::Shape,
};

/// An arc from x of the centre marker towards y, closed as asked.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("center_marker")?;
    let angle = cells.angle("angle_extent", FRAC_PI_2)?;
    let mut points = arc_points(cells.radius(&on)?, angle, cells.sides("segment_count")?);
    let first = points[0];
    match database.text(id, "close") {
        Some("chord" | "yes") => points.push(first),
        Some("sector") => points.extend([DVec3::ZERO, first]),
        _ => {}
    }
    Ok(Placed { on, shape: Shape::Lines(vec![points]) })
}
