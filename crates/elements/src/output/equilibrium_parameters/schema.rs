//! Names, types, units and defaults of the settings of static equilibrium.

use schema::{Class, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "equilibrium_parameters",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "EQUILIBRIUM_PARAMETERS_",
    statement: Some("EQUILIBRIUM"),
    groups: &[Group {
        command: "executive_control set equilibrium_parameters",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::yes_no("dynamic").doc("find equilibrium by a dynamic run"),
            Field::real("alimit", Dimension::ANGLE).doc("largest rotation in one iteration"),
            Field::real("error", Dimension::NONE).doc("error allowed"),
            Field::real("imbalance", Dimension::FORCE).doc("force out of balance that is allowed"),
            Field::integer("maxit").doc("iterations at most"),
            Field::yes_no("pattern_for_jacobian").doc("iterations at which the matrix is evaluated anew"),
            Field::real("stability", Dimension::NONE).doc("share of mass and damping added to the stiffness"),
            Field::real("tlimit", Dimension::NONE).doc("largest translation in one iteration"),
            Field::real("global_damping", Dimension::NONE).doc("damping of the dynamic run"),
            Field::real("settling_time", Dimension::TIME).doc("time the dynamic run may take"),
            Field::real("acceleration_error", Dimension::NONE).doc("acceleration below which it is at rest"),
            Field::real("kinetic_energy_error", Dimension::NONE).doc("kinetic energy below which it is at rest"),
            Field::choice("static_method", &["original", "advanced", "aggressive", "all"]).doc("method of solution"),
            Field::real("atol", Dimension::NONE).doc("absolute tolerance"),
            Field::real("rtol", Dimension::NONE).doc("relative tolerance"),
            Field::integer("maxitl").doc("iterations of the linear solver at most"),
            Field::real("etamax", Dimension::NONE).doc("loosest forcing term"),
            Field::real("eta", Dimension::NONE).doc("forcing term"),
        ],
        rules: &[],
        doc: "how static equilibrium is found; one set for each model, made by the first use",
    }],
};
