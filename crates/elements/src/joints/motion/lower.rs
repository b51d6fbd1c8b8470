//! A motion becomes an equation that follows a function of time.

use equations::{
    Axis, FrameId,
    constraints::{Drive, Driven, TimeFunction},
};
use model::ObjectId;
use schema::Dimension;
use text::Diagnostic;

use super::integral::Integral;
use crate::{
    lower::Lowering,
    runtime::{self, TimeOnly},
};

pub fn lower(lowering: &mut Lowering<'_>, motion: ObjectId) {
    let name = lowering.name(motion);
    let Some((i, j, drive)) = what_is_driven(lowering, motion) else { return };
    let Some(function) = function_of(lowering, motion, drive) else { return };
    let constraint = Driven::new(name, &lowering.frames, i, j, drive, function);
    lowering.add_constraint(motion, Box::new(constraint));
}

/// Frames and coordinate, from the joint or from markers and axis.
fn what_is_driven(lowering: &mut Lowering<'_>, motion: ObjectId) -> Option<(FrameId, FrameId, Drive)> {
    let database = lowering.database;
    let Some(joint) = database.reference(motion, "joint_name") else {
        let i = lowering.frame_cell(motion, "i_marker_name", "motion/no-marker");
        let j = lowering.frame_cell(motion, "j_marker_name", "motion/no-marker");
        let drive = match database.text(motion, "axis").unwrap_or("z").to_ascii_lowercase().as_str() {
            "x" => Drive::Translation(Axis::X),
            "y" => Drive::Translation(Axis::Y),
            "b1" => Drive::B1,
            "b2" => Drive::B2,
            "b3" => Drive::B3,
            _ => Drive::Translation(Axis::Z),
        };
        return Some((i?, j?, drive));
    };
    let name = lowering.name(motion);
    if !crate::lower::is_active(database, joint) {
        lowering.report(
            Diagnostic::error("motion/inactive-joint", format!("motion `{name}` drives an inactive joint"))
                .help("activate the joint or deactivate the motion"),
        );
        return None;
    }
    let rotational = database.text(motion, "type_of_freedom").map(|word| word.eq_ignore_ascii_case("rotational"));
    let (can_turn, can_slide) = crate::joints::between::coordinates_of(database.object(joint).class);
    let turns = rotational.unwrap_or(can_turn);
    if (turns && !can_turn) || (!turns && !can_slide) {
        let joint = lowering.name(joint);
        let how = if turns { "turn about" } else { "slide along" };
        lowering.report(
            Diagnostic::error("motion/wrong-joint", format!("motion `{name}` cannot drive joint `{joint}`"))
                .note(format!("that joint does not {how} one axis"))
                .help("drive a revolute, translational or cylindrical joint, or two markers with `axis`"),
        );
        return None;
    }
    let i = lowering.frame_cell(joint, "i_marker_name", "joint/no-marker");
    let j = lowering.frame_cell(joint, "j_marker_name", "joint/no-marker");
    Some((i?, j?, if turns { Drive::Rotation } else { Drive::Translation(Axis::Z) }))
}

/// The prescribed displacement as a function of time, SI.
fn function_of(lowering: &mut Lowering<'_>, motion: ObjectId, drive: Drive) -> Option<Box<dyn TimeFunction>> {
    let name = lowering.name(motion);
    let text = runtime::text_of(lowering.database, motion, "function");
    if text.trim().is_empty() {
        lowering.report(
            Diagnostic::error("motion/no-function", format!("motion `{name}` has no function"))
                .help(format!("constraint modify motion_generator motion_name={name} function=\"...\"")),
        );
        return None;
    }
    let compiled = runtime::compile(lowering, motion, &text)?;
    if !compiled.function.is_function_of_time_only() {
        lowering.report(
            Diagnostic::error(
                "motion/state",
                format!("the function of motion `{name}` depends on the state of the model"),
            )
            .note(format!("the function is `{text}`"))
            .help("a motion can follow time only"),
        );
        return None;
    }
    let value = if matches!(drive, Drive::Translation(_)) { lowering.factor(Dimension::LENGTH) } else { 1.0 };
    let time = lowering.factor(Dimension::TIME);
    let function = TimeOnly { function: compiled.function, value, time };
    let order = match lowering.database.text(motion, "time_derivative").unwrap_or("displacement") {
        word if word.eq_ignore_ascii_case("velocity") => 1,
        word if word.eq_ignore_ascii_case("acceleration") => 2,
        _ => return Some(Box::new(function)),
    };
    let start = |translation: &str, rotation: &str| {
        let cell = if matches!(drive, Drive::Translation(_)) { translation } else { rotation };
        lowering.database.si(motion, cell).unwrap_or(0.0)
    };
    // The derivative is given in model units per power of model time.
    let rate = TimeOnly { value: value / time.powi(order), ..function };
    let displacement = start("displacement_ic", "rotational_displacement_ic");
    let velocity = start("velocity_ic", "rotational_velocity_ic");
    Some(Box::new(Integral::new(rate, order as usize, displacement, velocity)))
}
