//! ORI_ functions: body 3-1-3 angles in the current angle unit, whatever the session's sequence.
//!
//! Functions that aim at frames (ORI_ALIGN_AXIS, ORI_ALONG_AXIS, ORI_IN_PLANE, ORI_RELATIVE_TO)
//! answer in the frame of the owner's parent, so that the axis really points there when the owner's
//! part is turned; the others answer in the global frame or in the one they name.

use glam::{DMat3, DVec3};
use model::Value;

use super::{Arguments, Function, function, location::direction, location::normal, orientation};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function(
        "ORI_ALIGN_AXIS",
        "frame, axes",
        "orientation with one axis along or against an axis of a frame",
        align_axis,
    ),
    function(
        "ORI_ALIGN_AXIS_EUL",
        "orientation, axes",
        "orientation with one axis along or against an axis of another orientation",
        |a| {
            let rotation = aligned(&a.rotation(0)?, a)?;
            orientation(&rotation, a)
        },
    ),
    function(
        "ORI_ALL_AXES",
        "points, axes",
        "orientation from three points: first axis along two of them, second in their plane",
        all_axes,
    ),
    function(
        "ORI_ALONG_AXIS",
        "from, to, axis",
        "orientation with an axis pointing from one frame to another",
        along_axis,
    ),
    function(
        "ORI_FRAME_MIRROR",
        "orientation, frame, plane, axes",
        "image of an orientation in a coordinate plane of a frame",
        mirror,
    ),
    function("ORI_GLOBAL", "orientation, frame", "global form of an orientation given in a frame", |a| {
        let rotation = a.rotation(0)?;
        orientation(&(a.turn(1)? * rotation), a)
    }),
    function(
        "ORI_IN_PLANE",
        "from, to, aside, axis_and_plane",
        "orientation from three frames: axis along two of them, plane through the third",
        in_plane,
    ),
    function("ORI_LOCAL", "orientation, frame", "an orientation given globally, seen from a frame", |a| {
        let rotation = a.rotation(0)?;
        orientation(&(a.turn(1)?.transpose() * rotation), a)
    }),
    function(
        "ORI_MIRROR",
        "orientation, frame, plane, axes",
        "image of an orientation in a coordinate plane of a frame",
        mirror,
    ),
    function("ORI_ONE_AXIS", "points, axis", "orientation with an axis along the line of two points", one_axis),
    function("ORI_ORI", "orientation, from, to", "an orientation changed from one frame to another", |a| {
        let (rotation, from, to) = (a.rotation(0)?, a.turn(1)?, a.turn(2)?);
        orientation(&(to.transpose() * from * rotation), a)
    }),
    function(
        "ORI_PLANE_MIRROR",
        "orientation, points, axes",
        "image of an orientation in the plane of three points",
        plane_mirror,
    ),
    function(
        "ORI_RELATIVE_TO",
        "orientation, frame",
        "orientation given in a frame, as the object that uses it stores it",
        relative_to,
    ),
];

/// A global rotation as angles in the frame of the owner.
fn for_owner(rotation: &DMat3, a: &mut Arguments) -> Outcome<Value> {
    let owner = a.owner_turn();
    orientation(&(owner.transpose() * *rotation), a)
}

fn relative_to(a: &mut Arguments) -> Outcome<Value> {
    let (rotation, frame) = (a.rotation(0)?, a.turn(1)?);
    let owner = a.owner_turn();
    if owner == frame {
        return Ok(a.values[0].clone());
    }
    orientation(&(owner.transpose() * frame * rotation), a)
}

/// Rotation whose columns are x, y, z, from two of them at given places.
fn from_axes(first: (usize, DVec3), second: (usize, DVec3)) -> DMat3 {
    let third = 3 - first.0 - second.0;
    let cross = first.1.cross(second.1);
    let mut columns = [DVec3::ZERO; 3];
    columns[first.0] = first.1;
    columns[second.0] = second.1;
    columns[third] = if (first.0 + 1) % 3 == second.0 { cross } else { -cross };
    DMat3::from_cols(columns[0], columns[1], columns[2])
}

/// Axis `a` of the result lies along axis `b` of the base, or against it. The others follow in
/// cyclic order; against it they change places, so that the result stays right-handed.
fn aligned(base: &DMat3, arguments: &Arguments) -> Outcome<DMat3> {
    let text = arguments.text(1)?.trim().to_ascii_lowercase();
    let axis = |letter: u8| (b'x'..=b'z').contains(&letter).then(|| usize::from(letter - b'x'));
    let parts = match *text.as_bytes() {
        [a, b] | [a, b'+', b] => axis(a).zip(axis(b)).map(|(a, b)| (a, b, false)),
        [a, b'-', b] => axis(a).zip(axis(b)).map(|(a, b)| (a, b, true)),
        _ => None,
    };
    let Some((a, b, against)) = parts else {
        return Err(arguments.error(format!("the alignment must be like \"xy\", \"x+y\" or \"x-y\", not \"{text}\"")));
    };
    let mut columns = [DVec3::ZERO; 3];
    columns[a] = if against { -base.col(b) } else { base.col(b) };
    let (next, last) = if against { (2, 1) } else { (1, 2) };
    columns[(a + 1) % 3] = base.col((b + next) % 3);
    columns[(a + 2) % 3] = base.col((b + last) % 3);
    Ok(DMat3::from_cols(columns[0], columns[1], columns[2]))
}

fn align_axis(a: &mut Arguments) -> Outcome<Value> {
    let frame = a.turn(0)?;
    let rotation = aligned(&frame, a)?;
    for_owner(&rotation, a)
}

/// One axis along a direction. The turn about it is free: another axis is kept horizontal, y, or x
/// where y itself is directed. That reproduces what Adams exports show.
fn directed(axis: usize, direction: DVec3) -> DMat3 {
    let horizontal = direction.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::Y);
    let other = usize::from(axis != 1);
    from_axes((axis, direction), (other, horizontal))
}

fn along_axis(a: &mut Arguments) -> Outcome<Value> {
    let (from, to, axis) = (a.origin(0)?, a.origin(1)?, a.axis(2)?);
    let rotation = directed(axis, direction(from, to, a)?);
    for_owner(&rotation, a)
}

fn one_axis(a: &mut Arguments) -> Outcome<Value> {
    let ([from, to], axis) = (a.points::<2>(0)?, a.axis(1)?);
    let rotation = directed(axis, direction(from, to, a)?);
    orientation(&rotation, a)
}

/// First axis from the first to the second point, second axis in the plane, on the side of the
/// third point.
fn plane_rotation(points: [DVec3; 3], first: usize, second: usize, a: &Arguments) -> Outcome<DMat3> {
    normal(points, a)?; // refuses points on one line
    let along = direction(points[0], points[1], a)?;
    let aside = (points[2] - points[0]).reject_from_normalized(along);
    Ok(from_axes((first, along), (second, aside.normalize())))
}

fn all_axes(a: &mut Arguments) -> Outcome<Value> {
    let (points, (first, second)) = (a.points::<3>(0)?, a.two_axes(1)?);
    let rotation = plane_rotation(points, first, second, a)?;
    orientation(&rotation, a)
}

/// `z_zx`: the z axis is directed, the zx plane holds the third point.
fn in_plane(a: &mut Arguments) -> Outcome<Value> {
    let points = [a.origin(0)?, a.origin(1)?, a.origin(2)?];
    let text = a.text(3)?.trim().to_ascii_lowercase();
    let axis = |letter: u8| (b'x'..=b'z').contains(&letter).then(|| usize::from(letter - b'x'));
    let axes = match *text.as_bytes() {
        [first, b'_', p, q] if p != q && (p == first || q == first) => {
            axis(first).zip(axis(if p == first { q } else { p }))
        }
        _ => None,
    };
    let Some((first, second)) = axes else {
        return Err(a.error(format!("axis and plane must be like \"z_zx\", not \"{text}\"")));
    };
    let rotation = plane_rotation(points, first, second, a)?;
    for_owner(&rotation, a)
}

/// The two named axes reflected at a plane; the third follows by the right-hand rule.
fn reflected(rotation: &DMat3, normal: DVec3, (i, j): (usize, usize)) -> DMat3 {
    let reflect = |v: DVec3| v - 2.0 * v.dot(normal) * normal;
    from_axes((i, reflect(rotation.col(i))), (j, reflect(rotation.col(j))))
}

fn mirror(a: &mut Arguments) -> Outcome<Value> {
    let (rotation, frame, (p, q), axes) = (a.rotation(0)?, a.turn(1)?, a.two_axes(2)?, a.two_axes(3)?);
    let rotation = reflected(&rotation, frame.col(3 - p - q), axes);
    orientation(&rotation, a)
}

fn plane_mirror(a: &mut Arguments) -> Outcome<Value> {
    let (rotation, plane, axes) = (a.rotation(0)?, a.points::<3>(1)?, a.two_axes(2)?);
    let rotation = reflected(&rotation, normal(plane, a)?, axes);
    orientation(&rotation, a)
}
