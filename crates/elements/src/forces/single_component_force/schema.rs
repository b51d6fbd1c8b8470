//! Names, types, units and defaults of a single-component force.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "single_component_force",
    word: "Force",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "SFORCE_",
    statement: Some("SFORCE"),
    groups: &[
        Group {
            command: "force create direct single_component_force",
            creates: true,
            object: "single_component_force_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::choice("type_of_freedom", &["translational", "rotational"])
                    .default_word("translational")
                    .doc("whether it moves along or turns about the axis"),
                common::I_MARKER,
                common::J_MARKER,
                Field::on_off("action_only")
                    .default_word("off")
                    .keyword("ACTIONONLY")
                    .doc("the reaction on J is left out"),
                common::FUNCTION,
                common::USER_FUNCTION,
                common::ROUTINE,
                Field::real("error", Dimension::NONE).keyword("ERROR").doc("error allowed"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: &[
                Rule::AtMostOne(&["function", "user_function"]),
                Rule::AtLeastOne(&["function", "user_function"]),
                Rule::AtMostOne(&["i_marker_name", "i_part_name"]),
                Rule::AtLeastOne(&["i_marker_name", "i_part_name"]),
                Rule::AtMostOne(&["j_marker_name", "j_part_name"]),
                Rule::AtLeastOne(&["j_marker_name", "j_part_name"]),
                common::ONE_ORIENTATION,
            ],
            doc: "a force along a line or a torque about an axis, given by a function",
        },
        attributes::FORCE,
    ],
};
