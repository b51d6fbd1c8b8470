//! Names, types, units and defaults of an array of states.

use schema::{Class, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "array_x",
    word: "Array",
    families: &["array", "data_element"],
    parents: &["model"],
    prefix: "ARRAY_",
    statement: Some("ARRAY"),
    groups: &[
        Group {
            command: "data_element create array x_state_array",
            creates: true,
            object: "array_name",
            fields: &[common::ADAMS_ID, common::COMMENTS, fields::SIZE],
            rules: &[],
            doc: "the states of an equation",
        },
        attributes::DATA_ELEMENT,
    ],
};
