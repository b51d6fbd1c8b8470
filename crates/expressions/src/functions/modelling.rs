//! Distances and angles between frames. The arguments are *to, from, axes*; lengths and angles in
//! the units in force.

use model::{Sequence, Value};

use super::{Arguments, Function, function, real};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function("DM", "to, [from]", "distance between two frames", |a| real(displacement(a)?.length())),
    function("DX", "to, [from], [axes]", "x component of the way from one frame to another", |a| component(a, 0)),
    function("DY", "to, [from], [axes]", "y component of the way from one frame to another", |a| component(a, 1)),
    function("DZ", "to, [from], [axes]", "z component of the way from one frame to another", |a| component(a, 2)),
    function("AX", "of, [from]", "angle of a frame about the x axis of another", |a| {
        turn(a, |r| (-r.col(2).y).atan2(r.col(2).z))
    }),
    function("AY", "of, [from]", "angle of a frame about the y axis of another", |a| {
        turn(a, |r| r.col(2).x.atan2(r.col(2).z))
    }),
    function("AZ", "of, [from]", "angle of a frame about the z axis of another", |a| {
        turn(a, |r| r.col(0).y.atan2(r.col(0).x))
    }),
    function("PSI", "of, [from]", "first body 3-1-3 angle of a frame seen from another", |a| {
        turn(a, |r| model::angles_of(r)[0])
    }),
    function("THETA", "of, [from]", "second body 3-1-3 angle of a frame seen from another", |a| {
        turn(a, |r| model::angles_of(r)[1])
    }),
    function("PHI", "of, [from]", "third body 3-1-3 angle of a frame seen from another", |a| {
        turn(a, |r| model::angles_of(r)[2])
    }),
    function("YAW", "of, [from]", "yaw angle of a frame seen from another", |a| {
        turn(a, |r| sequence_angles(r, Sequence { body: true, axes: [2, 1, 0] })[0])
    }),
    // Adams gives the negative of the second angle.
    function("PITCH", "of, [from]", "pitch angle of a frame seen from another", |a| {
        turn(a, |r| -sequence_angles(r, Sequence { body: true, axes: [2, 1, 0] })[1])
    }),
    function("ROLL", "of, [from]", "roll angle of a frame seen from another", |a| {
        turn(a, |r| sequence_angles(r, Sequence { body: true, axes: [2, 1, 0] })[2])
    }),
];

/// From the second frame to the first, in global axes.
fn displacement(a: &mut Arguments) -> Outcome<glam::DVec3> {
    let to = a.origin(0)?;
    let from = if a.len() > 1 { a.origin(1)? } else { glam::DVec3::ZERO };
    Ok(to - from)
}

fn component(a: &mut Arguments, axis: usize) -> Outcome<Value> {
    let difference = displacement(a)?;
    let axes = if a.len() > 2 { a.turn(2)? } else { glam::DMat3::IDENTITY };
    real(axes.col(axis).dot(difference))
}

/// An angle (rad) of the first frame seen from the second, in the current angle unit.
fn turn(a: &mut Arguments, angle: impl Fn(&glam::DMat3) -> f64) -> Outcome<Value> {
    let object = a.turn(0)?;
    let reference = if a.len() > 1 { a.turn(1)? } else { glam::DMat3::IDENTITY };
    real(angle(&(reference.transpose() * object)) / a.angle_unit())
}

/// Angles (rad) of a rotation in any of the 24 sequences; the third angle is 0 where the first and
/// third turn about the same line.
pub(super) fn sequence_angles(rotation: &glam::DMat3, sequence: Sequence) -> [f64; 3] {
    if !sequence.body {
        // Space-fixed turns in one order are body-fixed turns in the other.
        let [a, b, c] = sequence.axes;
        let [x, y, z] = sequence_angles(rotation, Sequence { body: true, axes: [c, b, a] });
        return [z, y, x];
    }
    let [i, j, k] = sequence.axes.map(usize::from);
    let m = |row: usize, column: usize| rotation.col(column)[row];
    let parity = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    if i == k {
        let other = 3 - i - j;
        let sine = m(i, j).hypot(m(i, other));
        let second = sine.atan2(m(i, i));
        if sine > 1e-12 {
            return [m(j, i).atan2(-parity * m(other, i)), second, m(i, j).atan2(parity * m(i, other))];
        }
        return [(parity * m(other, j)).atan2(m(j, j)), second, 0.0];
    }
    let cosine = m(i, i).hypot(m(i, j));
    let second = (parity * m(i, k)).atan2(cosine);
    if cosine > 1e-12 {
        return [(-parity * m(j, k)).atan2(m(k, k)), second, (-parity * m(i, j)).atan2(m(i, i))];
    }
    [(parity * m(k, j)).atan2(m(j, j)), second, 0.0]
}
