//! Names, types, units and defaults of a field element.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "field",
    word: "Field",
    families: &["force", "element_like"],
    parents: &["model"],
    prefix: "FIELD_",
    statement: Some("FIELD"),
    groups: &[
        Group {
            command: "force create element_like field",
            creates: true,
            object: "field_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("translation_at_preload", Dimension::LENGTH)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .doc("displacement of I in J at which the force is the preload"),
                Field::real("rotation_at_preload", Dimension::ANGLE)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .doc("rotation of I in J at which the torque is the preload"),
                Field::choice("formulation", &["linear", "nonlinear"])
                    .default_word("linear")
                    .keyword("FORMULATION")
                    .doc("law of the field"),
                Field::real("length_tolerance", Dimension::NONE)
                    .default(1.0e-5)
                    .keyword("LENGTH_TOL")
                    .doc("length below which a nonlinear field counts as having none"),
                Field::real("damping_ratio", Dimension::TIME)
                    .default(0.0)
                    .keyword("CRATIO")
                    .at_least(0.0)
                    .doc("damping matrix as a multiple of the stiffness matrix"),
                Field::real("force_preload", Dimension::FORCE)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .doc("force on I at the reference displacement"),
                Field::real("torque_preload", Dimension::TORQUE)
                    .count(Count::exactly(3))
                    .default(0.0)
                    .doc("torque on I at the reference rotation"),
                Field::reals("stiffness_matrix", 36).keyword("KMATRIX").doc("6 by 6 stiffness, column by column"),
                Field::reals("matrix_of_damping_terms", 36).keyword("CMATRIX").doc("6 by 6 damping, column by column"),
                common::USER_FUNCTION,
                common::ROUTINE,
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "six loads from six deformations through full matrices",
        },
        attributes::FORCE,
    ],
};
