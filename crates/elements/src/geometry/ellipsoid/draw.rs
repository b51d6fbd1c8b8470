//! Cells of an ellipsoid to its shape.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{geometry::Placed, place::Cells, shape::Shape};

/// An ellipsoid around the centre marker; its scale factors are diameters.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let diameter = DVec3::new(
        cells.above_zero("x_scale_factor")?,
        cells.above_zero("y_scale_factor")?,
        cells.above_zero("z_scale_factor")?,
    );
    Ok(Placed { on: cells.frame("center_marker")?, shape: Shape::Ellipsoid { half: diameter / 2.0 } })
}
