//! Names, types, units and defaults of a force vector.

use schema::{Class, Field, Group, Rule};

use crate::{attributes, common, forces::shared};

pub const CLASS: Class = Class {
    id: "force_vector",
    word: "Force_Vector",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "VFORCE_",
    statement: Some("VFORCE"),
    groups: &[
        Group {
            command: "force create direct force_vector",
            creates: true,
            object: "force_vector_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER.required(),
                shared::J_FLOATING_MARKER,
                shared::J_PART,
                shared::J_MARKER_ID,
                shared::REF_MARKER.required(),
                Field::function("x_force_function").keyword("FX").doc("force along x of the reference marker"),
                Field::function("y_force_function").keyword("FY").doc("force along y of the reference marker"),
                Field::function("z_force_function").keyword("FZ").doc("force along z of the reference marker"),
                Field::function("xyz_force_function")
                    .keyword("FXYZ")
                    .doc("three components of the force in one function"),
                common::USER_FUNCTION,
                common::ROUTINE,
                shared::ERROR,
            ],
            rules: &[
                Rule::AtMostOne(&["j_floating_marker_name", "j_part_name"]),
                Rule::AtLeastOne(&["j_floating_marker_name", "j_part_name"]),
                Rule::AtMostOne(&["x_force_function", "xyz_force_function"]),
                Rule::AtMostOne(&["y_force_function", "xyz_force_function"]),
                Rule::AtMostOne(&["z_force_function", "xyz_force_function"]),
            ],
            doc: "a force of three components given by functions",
        },
        attributes::FORCE,
    ],
};
