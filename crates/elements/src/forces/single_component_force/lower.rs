//! A single-component force becomes a scalar load between two frames.

use equations::{Axis, ScalarAction};
use model::ObjectId;
use schema::Dimension;
use text::Diagnostic;

use super::element::FunctionForce;
use crate::{
    lower::Lowering,
    runtime::{self, StateFunction},
};

pub fn lower(lowering: &mut Lowering<'_>, force: ObjectId) {
    let database = lowering.database;
    let name = lowering.name(force);
    let i = lowering.frame_cell(force, "i_marker_name", "force/no-marker");
    let j = lowering.frame_cell(force, "j_marker_name", "force/no-marker");
    let text = runtime::text_of(database, force, "function");
    if text.trim().is_empty() {
        lowering.report(Diagnostic::error("force/no-function", format!("force `{name}` has no function")).help(
            format!("force modify direct single_component_force single_component_force_name={name} function=\"...\""),
        ));
        return;
    }
    let compiled = runtime::compile(lowering, force, &text);
    let (Some(i), Some(j), Some(compiled)) = (i, j, compiled) else { return };
    let rotational = database.text(force, "type_of_freedom").is_some_and(|w| w.eq_ignore_ascii_case("rotational"));
    let reaction = database.flag(force, "action_only") != Some(true);
    let (action, dimension) = match (rotational, reaction) {
        (true, _) => (ScalarAction::Torque(Axis::Z), Dimension::TORQUE),
        (false, true) => (ScalarAction::Line, Dimension::FORCE),
        (false, false) => (ScalarAction::Force(Axis::Z), Dimension::FORCE),
    };
    let unit = lowering.factor(dimension);
    let Some(function) = StateFunction::new(lowering, force, compiled, unit) else { return };
    let mut bodies = vec![lowering.body_of_frame(i), lowering.body_of_frame(j)];
    bodies.extend(function.bodies());
    let bodies = crate::lower::distinct_bodies(&bodies);
    lowering.add_force(force, Box::new(FunctionForce { name, i, j, bodies, action, reaction, function }));
}
