//! Names, types, units and defaults of a modal force.

use schema::{Class, Field, Group, Kind, Rule};

use crate::{attributes, common, forces::shared};

pub const CLASS: Class = Class {
    id: "modal_force",
    word: "Modal_Force",
    families: &["force", "direct"],
    parents: &["model"],
    prefix: "MFORCE_",
    statement: Some("MFORCE"),
    groups: &[
        Group {
            command: "force create direct modal_force",
            creates: true,
            object: "modal_force_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("flex_body", "body").required().keyword("FLEX_BODY").doc("flexible body that is loaded"),
                shared::J_FLOATING_MARKER,
                Field::object("j_part_name", "body")
                    .doc("body that gets the reaction; a floating marker is made on it"),
                shared::J_MARKER_ID,
                Field::integer("case_index").keyword("CASE_INDEX").doc("load case stored with the flexible body"),
                Field::function("scale").keyword("SCALE").doc("factor on the load case"),
                Field::new("force_function", Kind::Real).many().doc("constants handed to a subroutine for modal loads"),
                common::USER_FUNCTION,
                common::ROUTINE,
            ],
            rules: &[Rule::AtMostOne(&["case_index", "user_function"]), Rule::AtMostOne(&["scale", "user_function"])],
            doc: "a distributed load on a flexible body in terms of its modes",
        },
        attributes::FORCE,
    ],
};
