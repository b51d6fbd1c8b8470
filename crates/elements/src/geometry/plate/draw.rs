//! Cells of a plate to its shape.

use glam::{DMat3, DVec3};
use model::{Database, ObjectId, Pose, Value};
use text::Diagnostic;

use crate::{
    geometry::{Placed, round_outline},
    place::{Cells, OnBody, on_body},
    shape::Shape,
};

/// A plate in the plane through its markers, which are the centres of its corners.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let (thickness, radius) = (cells.above_zero("width")?, cells.above_zero("radius")?);
    let markers = database.value(id, "marker_name").map(Value::objects).unwrap_or_default();
    let frames: Vec<OnBody> = markers.iter().filter_map(|&m| on_body(database, m)).collect();
    let flat = || cells.trouble("geometry/degenerate", "has its markers on one line");
    let [first, second, _, ..] = frames.as_slice() else {
        return Err(cells.trouble("geometry/missing-value", "has fewer than three markers"));
    };
    let points: Vec<DVec3> = frames.iter().map(|f| cells.relative(first, f).origin).collect();
    // Twice the area as a vector, by the trapezoids between neighbours.
    let next = points.iter().cycle().skip(1);
    let area = points.iter().zip(next).map(|(a, b)| a.cross(*b)).sum::<DVec3>();
    let size = points.iter().map(|p| p.length()).fold(0.0, f64::max);
    let normal = area.try_normalize().filter(|_| area.length() > 1e-9 * size * size).ok_or_else(flat)?;
    let along = cells.relative(first, second).origin;
    let x = (along - normal * along.dot(normal)).try_normalize().ok_or_else(flat)?;
    let rotation = DMat3::from_cols(x, normal.cross(x), normal);
    let corners: Vec<_> = points.iter().map(|p| (rotation.transpose() * *p).truncate()).collect();
    let shape = Shape::Plate { outline: round_outline(&corners, radius), thickness };
    let local = Pose { origin: DVec3::ZERO, rotation };
    Ok(Placed { on: OnBody { body: first.body, pose: first.pose.then(&local) }, shape })
}
