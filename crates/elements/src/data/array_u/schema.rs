//! Names, types, units and defaults of an array of inputs.

use schema::{Class, Field, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "array_u",
    word: "Array",
    families: &["array", "data_element"],
    parents: &["model"],
    prefix: "ARRAY_",
    statement: Some("ARRAY"),
    groups: &[
        Group {
            command: "data_element create array u_input_array",
            creates: true,
            object: "array_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                fields::SIZE,
                Field::objects("variable_name", "solver_variable")
                    .required()
                    .keyword("VARIABLES")
                    .doc("variables that are the inputs, in order"),
            ],
            rules: &[],
            doc: "the inputs of an equation, one variable each",
        },
        attributes::DATA_ELEMENT,
    ],
};
