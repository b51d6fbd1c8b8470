//! Names, types, units and defaults of an array of start values.

use schema::{Class, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "array_ic",
    word: "Array",
    families: &["array", "data_element"],
    parents: &["model"],
    prefix: "ARRAY_",
    statement: Some("ARRAY"),
    groups: &[
        Group {
            command: "data_element create array ic_array",
            creates: true,
            object: "array_name",
            fields: &[common::ADAMS_ID, common::COMMENTS, fields::SIZE, fields::NUMBERS],
            rules: &[],
            doc: "start values of the states of an equation",
        },
        attributes::DATA_ELEMENT,
    ],
};
