//! Cells of a torus to its shape.

use std::f64::consts::TAU;

use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// A ring around z of the centre marker.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let (major, minor) = (cells.above_zero("major_radius")?, cells.above_zero("minor_radius")?);
    if minor > major {
        return Err(cells.trouble("geometry/degenerate", "has a tube thicker than its ring: it cuts itself"));
    }
    let angle = cells.angle("angle_extent", TAU)?;
    Ok(Placed { on: cells.frame("center_marker")?, shape: Shape::Torus { major, minor, angle } })
}
