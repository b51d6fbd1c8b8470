//! Names, types, units and defaults of a general constraint.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "general_constraint",
    word: "General_Constraint",
    families: &["constraint"],
    parents: &["model"],
    prefix: "GCON_",
    statement: Some("GCON"),
    groups: &[
        Group {
            command: "constraint create general_constraint",
            creates: true,
            object: "general_constraint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("i_marker_name", "marker").keyword("I").doc("marker whose body is constrained"),
                common::FUNCTION.doc("function of the state that stays zero"),
            ],
            rules: &[],
            doc: "keeps a function of the state at zero",
        },
        attributes::CONSTRAINT,
    ],
};
