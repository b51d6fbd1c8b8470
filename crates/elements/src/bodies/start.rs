//! How bodies start: initial velocities and coordinates that assembly keeps.

use glam::{DMat3, DVec3};
use model::{Database, ObjectId, Value};

use crate::lower::Lowering;

/// Start velocity of the centre of mass in ground axes, m/s: components are global, or along the
/// axes of the marker `vm`.
pub fn velocity(lowering: &Lowering<'_>, body: ObjectId) -> DVec3 {
    let components = components(lowering.database, body, ["vx", "vy", "vz"]);
    axes_of(lowering, body, "vm").unwrap_or(DMat3::IDENTITY) * components
}

/// Start angular velocity in ground axes, rad/s: components are global, or along the axes of the
/// marker `wm`.
pub fn angular_velocity(lowering: &Lowering<'_>, body: ObjectId) -> DVec3 {
    let components = components(lowering.database, body, ["wx", "wy", "wz"]);
    axes_of(lowering, body, "wm").unwrap_or(DMat3::IDENTITY) * components
}

fn axes_of(lowering: &Lowering<'_>, body: ObjectId, cell: &str) -> Option<DMat3> {
    let marker = lowering.database.reference(body, cell)?;
    Some(lowering.global_pose(marker).rotation)
}

fn components(database: &Database, body: ObjectId, names: [&str; 3]) -> DVec3 {
    DVec3::from_array(names.map(|name| database.si(body, name).unwrap_or(0.0)))
}

/// Which of x y z and three rotations assembly leaves as they are.
pub fn exact_coordinates(database: &Database, body: ObjectId) -> [bool; 6] {
    let words: Vec<&str> = match database.value(body, "exact_coordinates") {
        Some(Value::Text(word)) => vec![word],
        Some(Value::Texts(words)) => words.iter().map(String::as_str).collect(),
        _ => Vec::new(),
    };
    let given = |name: &str| words.iter().any(|w| w.eq_ignore_ascii_case(name) || w.eq_ignore_ascii_case("all"));
    ["x", "y", "z", "psi", "theta", "phi"].map(given)
}
