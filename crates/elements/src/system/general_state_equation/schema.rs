//! Names, types, units and defaults of a general state equation.

use schema::{Class, Dimension, Field, Group, Kind};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "general_state_equation",
    word: "General_State_Equation",
    families: &["equation"],
    parents: &["model"],
    prefix: "GSE_",
    statement: Some("GSE"),
    groups: &[
        Group {
            command: "part create equation general_state_equation",
            creates: true,
            object: "general_state_equation_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::integer("state_equation_count").keyword("NS").doc("number of continuous states"),
                Field::integer("output_equation_count").keyword("NO").required().doc("number of outputs"),
                Field::integer("discrete_state_equation_count").keyword("ND").doc("number of discrete states"),
                Field::object("x_state_array_name", common::ARRAY).keyword("X").doc("array of the states"),
                Field::object("u_input_array_name", common::ARRAY).keyword("U").doc("array of the inputs"),
                Field::object("y_output_array_name", common::ARRAY).keyword("Y").doc("array of the outputs"),
                Field::object("ic_array_name", common::ARRAY).keyword("IC").doc("array of the start values"),
                Field::object("discrete_state_array_name", common::ARRAY)
                    .keyword("XD")
                    .doc("array of the discrete states"),
                Field::object("discrete_ic_array_name", common::ARRAY)
                    .keyword("ICD")
                    .doc("array of the start values of discrete states"),
                Field::choice("df_dx_method", &["user"]).doc("who gives the derivatives of states by states"),
                Field::choice("df_du_method", &["user", "none", "unspecified"])
                    .doc("who gives the derivatives of states by inputs"),
                Field::choice("dg_dx_method", &["user", "none", "unspecified"])
                    .doc("who gives the derivatives of outputs by states"),
                Field::choice("dg_du_method", &["user", "none", "unspecified"])
                    .doc("who gives the derivatives of outputs by inputs"),
                Field::on_off("discrete").doc("whether there are discrete states"),
                Field::function("sample_period")
                    .keyword("SAMPLE_PERIOD")
                    .doc("time between updates of discrete states"),
                Field::new("user_sample_period", Kind::Real)
                    .many()
                    .doc("constants for a subroutine that gives the sample period"),
                Field::text("sample_routine").doc("library and entry of the subroutine for the sample period"),
                Field::real("sample_offset", Dimension::TIME).doc("time of the first update"),
                Field::on_off("static_hold")
                    .keyword("STATIC_HOLD")
                    .doc("whether states stay as they are in static analyses"),
                Field::on_off("implicit").doc("whether the equations of the states are implicit"),
                Field::on_off("statics_only").doc("whether the equations hold in static analyses alone"),
                common::USER_FUNCTION,
                common::ROUTINE,
                Field::texts("interface_routines")
                    .keyword("INTERFACE")
                    .doc("libraries and entries of the subroutines for derivatives, outputs, updates and samples"),
            ],
            rules: &[],
            doc: "a system of states that subroutines of the user evaluate",
        },
        attributes::EQUATION,
    ],
};
