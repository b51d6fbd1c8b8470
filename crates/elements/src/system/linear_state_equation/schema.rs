//! Names, types, units and defaults of a linear state equation.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "linear_state_equation",
    word: "Linear_State_Equation",
    families: &["equation"],
    parents: &["model"],
    prefix: "LSE_",
    statement: Some("LSE"),
    groups: &[
        Group {
            command: "part create equation linear_state_equation",
            creates: true,
            object: "linear_state_equation_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("x_state_array_name", common::ARRAY).keyword("X").required().doc("array of the states"),
                Field::object("u_input_array_name", common::ARRAY).keyword("U").doc("array of the inputs"),
                Field::object("y_output_array_name", common::ARRAY).keyword("Y").doc("array of the outputs"),
                Field::object("ic_array_name", common::ARRAY).keyword("IC").doc("array of the start values"),
                Field::object("a_state_matrix_name", common::MATRIX)
                    .keyword("A")
                    .required()
                    .doc("matrix from states to their derivatives"),
                Field::object("b_input_matrix_name", common::MATRIX)
                    .keyword("B")
                    .doc("matrix from inputs to derivatives"),
                Field::object("c_output_matrix_name", common::MATRIX).keyword("C").doc("matrix from states to outputs"),
                Field::object("d_feedforward_matrix_name", common::MATRIX)
                    .keyword("D")
                    .doc("matrix from inputs to outputs"),
                Field::on_off("static_hold")
                    .keyword("STATIC_HOLD")
                    .doc("whether states stay as they are in static analyses"),
            ],
            rules: &[],
            doc: "a linear system as four matrices",
        },
        attributes::EQUATION,
    ],
};
