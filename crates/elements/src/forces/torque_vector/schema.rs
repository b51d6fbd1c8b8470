//! Names, types, units and defaults of a torque vector.

use schema::{Class, Field, Group, Rule};

use crate::{attributes, common, forces::shared};

pub const CLASS: Class = Class {
    id: "torque_vector",
    word: "Torque_Vector",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "VTORQUE_",
    statement: Some("VTORQUE"),
    groups: &[
        Group {
            command: "force create direct torque_vector",
            creates: true,
            object: "torque_vector_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER.required(),
                shared::J_FLOATING_MARKER,
                shared::J_PART,
                shared::J_MARKER_ID,
                shared::REF_MARKER,
                Field::function("x_torque_function").keyword("TX").doc("torque about x of the reference marker"),
                Field::function("y_torque_function").keyword("TY").doc("torque about y of the reference marker"),
                Field::function("z_torque_function").keyword("TZ").doc("torque about z of the reference marker"),
                Field::function("xyz_torque_function")
                    .keyword("TXYZ")
                    .doc("three components of the torque in one function"),
                common::USER_FUNCTION,
                common::ROUTINE,
                shared::ERROR,
            ],
            rules: &[
                Rule::AtMostOne(&["j_floating_marker_name", "j_part_name"]),
                Rule::AtLeastOne(&["j_floating_marker_name", "j_part_name"]),
                Rule::AtMostOne(&["xyz_torque_function", "x_torque_function"]),
            ],
            doc: "a torque of three components given by functions",
        },
        attributes::FORCE,
    ],
};
