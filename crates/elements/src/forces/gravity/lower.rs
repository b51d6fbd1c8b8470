//! Gravity becomes one acceleration of all bodies.

use glam::DVec3;
use model::ObjectId;
use text::Diagnostic;

use crate::lower::Lowering;

pub fn lower(lowering: &mut Lowering<'_>, gravity: ObjectId) {
    let database = lowering.database;
    let component = |name| database.si(gravity, name).unwrap_or(0.0);
    let field = DVec3::new(
        component("x_component_gravity"),
        component("y_component_gravity"),
        component("z_component_gravity"),
    );
    let name = lowering.name(gravity);
    if !field.is_finite() {
        lowering.report(
            Diagnostic::error(
                "gravity/not-a-number",
                format!("a component of gravity `{name}` is not a finite number"),
            )
            .help("give `x_component_gravity`, `y_component_gravity`, `z_component_gravity` finite values"),
        );
        return;
    }
    if lowering.gravity != DVec3::ZERO {
        lowering.report(
            Diagnostic::warning(
                "gravity/given-twice",
                format!("gravity `{name}` replaces another active gravity field"),
            )
            .help("deactivate or delete all gravity fields but one"),
        );
    }
    lowering.gravity = field;
}
