//! Cells of an ellipse to its line.

use std::f64::consts::TAU;

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// Pieces of a whole turn.
const PIECES: f64 = 36.0;

/// The line from the start angle to the end angle.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("center_marker")?;
    let (major, minor) = (cells.above_zero("major_radius")?, cells.above_zero("minor_radius")?);
    let start = cells.number("start_angle")?;
    let end = database.si(id, "end_angle").unwrap_or(TAU);
    if !end.is_finite() || (end - start).abs() > 100.0 * TAU {
        return Err(cells.trouble("geometry/angle", "has angles that are more than 100 turns apart"));
    }
    let pieces = ((end - start).abs() / TAU * PIECES).ceil().max(1.0);
    let at = |k: u32| {
        let a = start + (end - start) * f64::from(k) / pieces;
        DVec3::new(major * a.cos(), minor * a.sin(), 0.0)
    };
    Ok(Placed { on, shape: Shape::Lines(vec![(0..=pieces as u32).map(at).collect()]) })
}
