//! Names, types, units and defaults of a transfer function.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "transfer_function",
    word: "Transfer_Function",
    families: &["equation"],
    parents: &["model"],
    prefix: "TFSISO_",
    statement: Some("TFSISO"),
    groups: &[
        Group {
            command: "part create equation transfer_function",
            creates: true,
            object: "transfer_function_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("x_state_array_name", common::ARRAY).keyword("X").required().doc("array of the states"),
                Field::object("u_input_array_name", common::ARRAY).keyword("U").required().doc("array of the inputs"),
                Field::object("y_output_array_name", common::ARRAY).keyword("Y").required().doc("array of the outputs"),
                Field::object("ic_array_name", common::ARRAY).keyword("IC").doc("array of the start values"),
                Field::on_off("static_hold")
                    .keyword("STATIC_HOLD")
                    .doc("whether states stay as they are in static analyses"),
                Field::real("numerator_coefficients", Dimension::NONE)
                    .many()
                    .required()
                    .keyword("NUMERATOR")
                    .doc("coefficients of the numerator, lowest power first"),
                Field::real("denominator_coefficients", Dimension::NONE)
                    .many()
                    .required()
                    .keyword("DENOMINATOR")
                    .doc("coefficients of the denominator, lowest power first"),
            ],
            rules: &[],
            doc: "a linear system as a ratio of polynomials",
        },
        attributes::EQUATION,
    ],
};
