//! Coordinates as commands take them: they are read in the coordinate system and the rotation sequence
//! that `defaults` set, and kept as x, y, z and as body 3-1-3 angles.

use glam::{DVec3, EulerRot};
use model::{CoordinateSystem, Database, Sequence, rotation_of};
use schema::{Field, Kind};

use crate::assign::AttributeInput;

/// Kept coordinates as they are typed now; none if they are typed as they are kept, or hold expressions.
pub(crate) fn typed(database: &Database, field: &Field, value: &AttributeInput) -> Option<AttributeInput> {
    let AttributeInput::List(items) = value else { return None };
    let numbers: Vec<f64> = items.iter().map(number).collect::<Option<_>>()?;
    let (places, []) = numbers.as_chunks::<3>() else { return None };
    let (settings, angle) = (database.settings(), database.units().angle.si);
    let typed: Vec<[f64; 3]> = match field.kind {
        Kind::Location if settings.coordinate_system != CoordinateSystem::Cartesian => {
            places.iter().map(|place| curved(settings.coordinate_system, *place, angle)).collect()
        }
        Kind::Orientation if settings.sequence != Sequence::BODY_313 => {
            places.iter().map(|angles| turned(settings.sequence, *angles, angle)).collect()
        }
        _ => return None,
    };
    Some(AttributeInput::List(typed.into_iter().flatten().map(AttributeInput::Number).collect()))
}

fn number(value: &AttributeInput) -> Option<f64> {
    match value {
        AttributeInput::Number(x) => Some(*x),
        AttributeInput::Integer(i) => Some(*i as f64),
        _ => None,
    }
}

/// x, y, z in another coordinate system; angles in units of `angle`.
fn curved(system: CoordinateSystem, [x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let turn = y.atan2(x) / angle;
    match system {
        CoordinateSystem::Cartesian => [x, y, z],
        // Radius, angle from x about z, height.
        CoordinateSystem::Cylindrical => [x.hypot(y), turn, z],
        // Distance, angle from x about z, angle from z.
        CoordinateSystem::Spherical => [DVec3::new(x, y, z).length(), turn, x.hypot(y).atan2(z) / angle],
    }
}

/// Body 3-1-3 angles as those of another sequence, in units of `angle`.
fn turned(sequence: Sequence, angles: [f64; 3], angle: f64) -> [f64; 3] {
    let rotation = rotation_of(Sequence::BODY_313, angles.map(|a| a * angle));
    // Turning about axes of space is turning about those of the body the other way round.
    let mut axes = sequence.axes;
    if !sequence.body {
        axes.reverse();
    }
    let order = match axes {
        [0, 1, 2] => EulerRot::XYZ,
        [0, 2, 1] => EulerRot::XZY,
        [1, 0, 2] => EulerRot::YXZ,
        [1, 2, 0] => EulerRot::YZX,
        [2, 0, 1] => EulerRot::ZXY,
        [2, 1, 0] => EulerRot::ZYX,
        [0, 1, 0] => EulerRot::XYX,
        [0, 2, 0] => EulerRot::XZX,
        [1, 0, 1] => EulerRot::YXY,
        [1, 2, 1] => EulerRot::YZY,
        [2, 1, 2] => EulerRot::ZYZ,
        _ => EulerRot::ZXZ,
    };
    let (a, b, c) = rotation.to_euler(order);
    let mut found = [a, b, c].map(|a| a / angle);
    if !sequence.body {
        found.reverse();
    }
    found
}
