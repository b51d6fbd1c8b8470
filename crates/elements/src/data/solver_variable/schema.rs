//! Names, types, units and defaults of a variable of the solver.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "solver_variable",
    word: "Adams_Variable",
    families: &["data_element"],
    parents: &["model"],
    prefix: "VARIABLE_",
    statement: Some("VARIABLE"),
    groups: &[
        Group {
            command: "data_element create variable",
            creates: true,
            object: "variable_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::real("initial_condition", Dimension::NONE).keyword("IC").doc("value the solver begins with"),
                Field::function("function").keyword("FUNCTION").doc("what the variable is at any time"),
                fields::USER_FUNCTION,
                fields::ROUTINE,
            ],
            rules: &[Rule::AtMostOne(&["function", "user_function"]), Rule::AtLeastOne(&["function", "user_function"])],
            doc: "an unknown of the solver that a function gives",
        },
        attributes::DATA_ELEMENT,
    ],
};
