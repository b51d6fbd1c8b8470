//! Names, types, units and defaults of a differential equation.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "differential_equation",
    word: "Differential_Equation",
    families: &["equation"],
    parents: &["model"],
    prefix: "DIFF_",
    statement: Some("DIFF"),
    groups: &[
        Group {
            command: "part create equation differential_equation",
            creates: true,
            object: "differential_equation_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::real("initial_condition", Dimension::NONE)
                    .required()
                    .keyword("IC")
                    .doc("start value of the state"),
                Field::true_false("no_initial_condition").doc("forget the start value"),
                common::FUNCTION.doc("derivative of the state, or what is zero where it is implicit"),
                common::USER_FUNCTION,
                common::ROUTINE,
                Field::on_off("implicit")
                    .keyword("IMPLICIT")
                    .doc("whether the function is zero instead of the derivative"),
                Field::on_off("static_hold")
                    .keyword("STATIC_HOLD")
                    .doc("whether states stay as they are in static analyses"),
                Field::on_off("dynamic_hold")
                    .keyword("DYNAMIC_HOLD")
                    .doc("whether the state stays as it is in dynamic analyses"),
            ],
            rules: &[Rule::AtMostOne(&["function", "user_function"]), Rule::AtLeastOne(&["function", "user_function"])],
            doc: "a state of the user with its differential equation",
        },
        attributes::EQUATION,
    ],
};
