//! Names, types, units and defaults of a string that the solver knows.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "string",
    word: "String",
    families: &["data_element"],
    parents: &["model"],
    prefix: "STRING_",
    statement: Some("STRING"),
    groups: &[
        Group {
            command: "data_element create string",
            creates: true,
            object: "string_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::text("string").required().keyword("STRING").doc("the text"),
            ],
            rules: &[],
            doc: "a text that subroutines read",
        },
        attributes::DATA_ELEMENT,
    ],
};
