//! What all joints share when they are lowered: two markers become two frames, and what is given
//! but not simulated is named.

use equations::{Constraint, Frame, FrameId, GROUND, constraints::Pair};
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::lower::{Lowering, word_of};

/// Lowers a joint whose equations need its two frames only.
pub fn lower(lowering: &mut Lowering<'_>, joint: ObjectId, make: fn(String, &[Frame], FrameId, FrameId) -> Pair) {
    report_unused(lowering, joint);
    let i = lowering.frame_cell(joint, "i_marker_name", "joint/no-marker");
    let j = lowering.frame_cell(joint, "j_marker_name", "joint/no-marker");
    let (Some(i), Some(j)) = (i, j) else { return };
    let name = lowering.name(joint);
    let pair = make(name, &lowering.frames, i, j);
    if check_bodies(lowering, joint, &pair, [i, j]) {
        lowering.add_constraint(joint, Box::new(pair));
    }
}

/// Refuses joints within one body and joints that would turn a point mass.
fn check_bodies(lowering: &mut Lowering<'_>, joint: ObjectId, pair: &Pair, ends: [FrameId; 2]) -> bool {
    let (name, word) = (lowering.name(joint), word_of(lowering.database, joint));
    let [a, b] = ends.map(|end| lowering.body_of_frame(end));
    if a == b {
        lowering.report(
            Diagnostic::error("joint/one-part", format!("both markers of {word} `{name}` are on the same part"))
                .help("use markers on two different parts"),
        );
        return false;
    }
    let turns = pair.list().iter().any(|e| !matches!(e, equations::constraints::Equation::Along(_)));
    let point_mass = [a, b].into_iter().find(|&body| body != GROUND && lowering.bodies[body.0 as usize].point_mass);
    if let Some(body) = point_mass.filter(|_| turns) {
        let mass = lowering.bodies[body.0 as usize].name.clone();
        lowering.report(
            Diagnostic::error(
                "joint/point-mass",
                format!("{} `{name}` holds the orientation of the point mass `{mass}`, which has none", pair.kind()),
            )
            .help("a point mass takes a spherical joint or an atpoint, inline or inplane primitive")
            .adams(format!("A point mass, such as {mass}, can be constrained with only a"))
            .adams("spherical joint, an atpoint joint primitive, an inline joint primitive,")
            .adams("or an inplane joint primitive. Do not connect a fixed joint ")
            .adams("to a point mass."),
        );
        return false;
    }
    true
}

/// Names start values and friction, which are kept but have no effect yet.
fn report_unused(lowering: &mut Lowering<'_>, joint: ObjectId) {
    const STARTS: [&str; 4] = ["rotational_ic", "angular_velocity_ic", "translational_ic", "velocity_ic"];
    let database = lowering.database;
    let given: Vec<_> = STARTS.into_iter().filter(|cell| database.value(joint, cell).is_some()).collect();
    let name = lowering.name(joint);
    if !given.is_empty() {
        let cells = given.join("`, `");
        lowering.report(
            Diagnostic::warning("joint/start-value", format!("`{cells}` of joint `{name}` has no effect yet"))
                .help("give the parts the start position and velocity instead"),
        );
    }
    if has_friction(database, joint) {
        lowering.report(
            Diagnostic::warning("joint/friction", format!("the friction of joint `{name}` is not simulated"))
                .help("set `friction_enabled = no` if the run is meant to go without it"),
        );
    }
}

fn has_friction(database: &Database, joint: ObjectId) -> bool {
    database.text(joint, "friction_enabled").is_some_and(|word| !word.eq_ignore_ascii_case("no"))
}

/// Whether a joint of a class turns about, and slides along, the z axis of its J marker.
pub fn coordinates_of(class: &schema::Class) -> (bool, bool) {
    match class.id {
        "joint_revolute" => (true, false),
        "joint_translational" => (false, true),
        "joint_cylindrical" => (true, true),
        _ => (false, false),
    }
}
