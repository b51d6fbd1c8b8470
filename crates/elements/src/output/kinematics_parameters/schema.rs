//! Names, types, units and defaults of the settings of kinematic analysis.

use schema::{Class, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "kinematics_parameters",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "KINEMATICS_PARAMETERS_",
    statement: Some("KINEMATICS"),
    groups: &[Group {
        command: "executive_control set kinematics_parameters",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::real("alimit", Dimension::ANGLE).doc("largest rotation in one iteration"),
            Field::real("error", Dimension::NONE).doc("error allowed at position level"),
            Field::integer("maxit").doc("iterations at most at position level"),
            Field::real("aerror", Dimension::NONE).doc("error allowed at acceleration level"),
            Field::integer("amaxit").doc("iterations at most at acceleration level"),
            Field::real("tlimit", Dimension::LENGTH).doc("largest translation in one iteration"),
            Field::real("hmax", Dimension::TIME).doc("largest step"),
            Field::yes_no("pattern_for_jacobian").doc("iterations at which the matrix is evaluated anew"),
            Field::yes_no("apattern_for_jacobian")
                .doc("iterations at which the matrix of accelerations is evaluated anew"),
        ],
        rules: &[],
        doc: "how a kinematic run is solved; one set for each model, made by the first use",
    }],
};
