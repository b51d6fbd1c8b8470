//! Names, types, units and defaults of a general force.

use schema::{Class, Field, Group, Rule};

use crate::{attributes, common, forces::shared};

pub const CLASS: Class = Class {
    id: "general_force",
    word: "General_Force",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "GFORCE_",
    statement: Some("GFORCE"),
    groups: &[
        Group {
            command: "force create direct general_force",
            creates: true,
            object: "general_force_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER.required(),
                shared::J_FLOATING_MARKER,
                shared::J_PART,
                shared::J_MARKER_ID,
                shared::REF_MARKER,
                Field::function("x_force_function").keyword("FX").doc("force along x of the reference marker"),
                Field::function("y_force_function").keyword("FY").doc("force along y of the reference marker"),
                Field::function("z_force_function").keyword("FZ").doc("force along z of the reference marker"),
                Field::function("x_torque_function").keyword("TX").doc("torque about x of the reference marker"),
                Field::function("y_torque_function").keyword("TY").doc("torque about y of the reference marker"),
                Field::function("z_torque_function").keyword("TZ").doc("torque about z of the reference marker"),
                Field::function("xyz_force_function")
                    .keyword("FXYZ")
                    .doc("three components of the force in one function"),
                Field::function("xyz_torque_function")
                    .keyword("TXYZ")
                    .doc("three components of the torque in one function"),
                common::USER_FUNCTION,
                common::ROUTINE,
                shared::ERROR,
            ],
            rules: &[
                Rule::AtMostOne(&["j_floating_marker_name", "j_part_name"]),
                Rule::AtMostOne(&["xyz_force_function", "x_force_function"]),
                Rule::AtMostOne(&["user_function", "x_force_function", "xyz_force_function"]),
            ],
            doc: "a force and a torque of three components each, given by functions",
        },
        attributes::FORCE,
    ],
};
