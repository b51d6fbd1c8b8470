//! Cells of a geometry point to its dot.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// A line without length at the marker.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let on = Cells { database, id }.frame("ref_marker_name")?;
    Ok(Placed { on, shape: Shape::Lines(vec![vec![DVec3::ZERO; 2]]) })
}
