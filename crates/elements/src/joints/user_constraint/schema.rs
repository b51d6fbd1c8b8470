//! Names, types, units and defaults of a user-written constraint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "user_constraint",
    word: "User_Constraint",
    families: &["constraint"],
    parents: &["model"],
    prefix: "UCON_",
    statement: Some("UCON"),
    groups: &[
        Group {
            command: "constraint create user_defined",
            creates: true,
            object: "user_constraint_name",
            fields: &[common::ADAMS_ID, common::COMMENTS, common::USER_FUNCTION.required(), common::ROUTINE],
            rules: &[],
            doc: "a constraint that a subroutine of the user evaluates",
        },
        attributes::CONSTRAINT,
    ],
};
