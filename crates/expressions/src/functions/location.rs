//! LOC_ functions: three coordinates. All answer in the global frame except LOC_RELATIVE_TO (frame
//! of the owner's parent) and those that name a target frame.

use glam::DVec3;
use model::Value;

use super::{Arguments, Function, function, location};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function("LOC_ALONG_LINE", "from, to, distance", "point at a distance from one frame towards another", along_line),
    function(
        "LOC_CYLINDRICAL",
        "radius, angle, height",
        "Cartesian coordinates of a point given in cylindrical ones",
        cylindrical,
    ),
    function("LOC_FRAME_MIRROR", "location, frame, plane", "image of a point in a coordinate plane of a frame", mirror),
    function("LOC_GLOBAL", "location, frame", "global coordinates of a point given in a frame", global),
    function("LOC_INLINE", "location, from, to", "unit vector from the origin of a frame to a point", inline),
    function("LOC_LOC", "location, from, to", "coordinates of a point changed from one frame to another", loc_loc),
    function("LOC_LOCAL", "location, frame", "coordinates in a frame of a point given globally", local),
    function("LOC_MIRROR", "location, frame, plane", "image of a point in a coordinate plane of a frame", mirror),
    function("LOC_ON_AXIS", "frame, distance, axis", "point at a distance along an axis of a frame", on_axis),
    function("LOC_ON_LINE", "points, distance", "point at a distance along the line of two points", on_line),
    function(
        "LOC_PERPENDICULAR",
        "points",
        "point one unit off the plane of three points, above the first",
        perpendicular,
    ),
    function("LOC_PLANE_MIRROR", "location, points", "image of a point in the plane of three points", plane_mirror),
    function(
        "LOC_RELATIVE_TO",
        "location, frame",
        "point given in a frame, in the coordinates of the object that uses it",
        relative_to,
    ),
    function(
        "LOC_SPHERICAL",
        "radius, angle, angle_from_z",
        "Cartesian coordinates of a point given in spherical ones",
        spherical,
    ),
    function("LOC_X_AXIS", "frame", "unit vector of the x axis of a frame", |a| axis(a, 0)),
    function("LOC_Y_AXIS", "frame", "unit vector of the y axis of a frame", |a| axis(a, 1)),
    function("LOC_Z_AXIS", "frame", "unit vector of the z axis of a frame", |a| axis(a, 2)),
];

/// Unit vector from one point to another.
pub(super) fn direction(from: DVec3, to: DVec3, a: &Arguments) -> Outcome<DVec3> {
    (to - from).try_normalize().ok_or_else(|| a.error("the two points coincide, so they give no direction"))
}

/// Unit normal of the plane of three points.
pub(super) fn normal(points: [DVec3; 3], a: &Arguments) -> Outcome<DVec3> {
    let [p, q, r] = points;
    let (u, v) = (q - p, r - p);
    let cross = u.cross(v);
    // Relative to the size of the triangle: 1e-12 is far above rounding of collinear points.
    if cross.length() <= 1e-12 * u.length() * v.length() {
        return Err(a.error("the three points lie on one line, so they give no plane"));
    }
    Ok(cross.normalize())
}

fn along_line(a: &mut Arguments) -> Outcome<Value> {
    let (from, to) = (a.origin(0)?, a.origin(1)?);
    location(from + a.number(2)? * direction(from, to, a)?)
}

fn cylindrical(a: &mut Arguments) -> Outcome<Value> {
    let (r, theta, z) = (a.number(0)?, a.number(1)? * a.angle_unit(), a.number(2)?);
    location(DVec3::new(r * theta.cos(), r * theta.sin(), z))
}

/// Theta turns about z from x, phi is the angle from z.
fn spherical(a: &mut Arguments) -> Outcome<Value> {
    let unit = a.angle_unit();
    let (r, theta, phi) = (a.number(0)?, a.number(1)? * unit, a.number(2)? * unit);
    location(r * DVec3::new(theta.cos() * phi.sin(), theta.sin() * phi.sin(), phi.cos()))
}

fn mirror(a: &mut Arguments) -> Outcome<Value> {
    let (point, frame, (i, j)) = (a.vector(0)?, a.frame(1)?, a.two_axes(2)?);
    let normal = frame.rotation.col(3 - i - j);
    location(point - 2.0 * (point - frame.origin).dot(normal) * normal)
}

fn plane_mirror(a: &mut Arguments) -> Outcome<Value> {
    let (point, plane) = (a.vector(0)?, a.points::<3>(1)?);
    let normal = normal(plane, a)?;
    location(point - 2.0 * (point - plane[0]).dot(normal) * normal)
}

/// A point given in a frame, in global coordinates. The origin of the frame stays where it is
/// however the frame is turned, so its turn is not noted as read then.
fn in_global(a: &mut Arguments, point: DVec3, frame: usize) -> Outcome<DVec3> {
    if point == DVec3::ZERO {
        return a.origin(frame);
    }
    let frame = a.frame(frame)?;
    Ok(frame.origin + frame.rotation * point)
}

fn global(a: &mut Arguments) -> Outcome<Value> {
    let point = a.vector(0)?;
    location(in_global(a, point, 1)?)
}

fn local(a: &mut Arguments) -> Outcome<Value> {
    let (point, frame) = (a.vector(0)?, a.frame(1)?);
    location(frame.rotation.transpose() * (point - frame.origin))
}

fn transformed(a: &mut Arguments) -> Outcome<DVec3> {
    let point = a.vector(0)?;
    let (point, to) = (in_global(a, point, 1)?, a.frame(2)?);
    Ok(to.rotation.transpose() * (point - to.origin))
}

fn loc_loc(a: &mut Arguments) -> Outcome<Value> {
    location(transformed(a)?)
}

fn inline(a: &mut Arguments) -> Outcome<Value> {
    let point = transformed(a)?;
    location(
        point
            .try_normalize()
            .ok_or_else(|| a.error("the location is the origin of the frame, so it has no direction"))?,
    )
}

fn relative_to(a: &mut Arguments) -> Outcome<Value> {
    let (point, owner) = (a.vector(0)?, a.owner_frame());
    if point == DVec3::ZERO {
        let origin = a.origin(1)?;
        return location(owner.rotation.transpose() * (origin - owner.origin));
    }
    let frame = a.frame(1)?;
    if owner == frame {
        return location(point);
    }
    location(owner.rotation.transpose() * (frame.origin + frame.rotation * point - owner.origin))
}

fn on_axis(a: &mut Arguments) -> Outcome<Value> {
    let (frame, distance, axis) = (a.frame(0)?, a.number(1)?, a.axis(2)?);
    location(frame.origin + distance * frame.rotation.col(axis))
}

fn on_line(a: &mut Arguments) -> Outcome<Value> {
    let [from, to] = a.points::<2>(0)?;
    location(from + a.number(1)? * direction(from, to, a)?)
}

/// One unit off the first point. The help page's example puts it on the side from which the points
/// run clockwise.
fn perpendicular(a: &mut Arguments) -> Outcome<Value> {
    let points = a.points::<3>(0)?;
    location(points[0] - normal(points, a)?)
}

fn axis(a: &mut Arguments, axis: usize) -> Outcome<Value> {
    let frame = a.turn(0)?;
    location(frame.col(axis))
}
