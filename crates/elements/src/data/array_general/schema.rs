//! Names, types, units and defaults of an array of numbers.

use schema::{Class, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "array_general",
    word: "Array",
    families: &["array", "data_element"],
    parents: &["model"],
    prefix: "ARRAY_",
    statement: Some("ARRAY"),
    groups: &[
        Group {
            command: "data_element create array general_array",
            creates: true,
            object: "array_name",
            fields: &[common::ADAMS_ID, common::COMMENTS, fields::SIZE, fields::NUMBERS],
            rules: &[],
            doc: "values that functions and subroutines read",
        },
        attributes::DATA_ELEMENT,
    ],
};
