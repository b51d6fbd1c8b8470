//! Names, types, units and defaults of a request.

use schema::{Class, Field, Group};

use crate::{common, data::fields};

pub const CLASS: Class = Class {
    id: "request",
    word: "Request",
    families: &[],
    parents: &["model"],
    prefix: "REQUEST_",
    statement: Some("REQUEST"),
    groups: &[Group {
        command: "output_control create request",
        creates: true,
        object: "request_name",
        fields: &[
            common::ADAMS_ID,
            Field::text("comment").keyword("COMMENT").doc("text kept with the request"),
            Field::texts("component_names").keyword("CNAMES").doc("names of the columns"),
            Field::texts("component_labels").keyword("CLABELS").doc("labels of the columns"),
            Field::text("results_name").keyword("RESULTS_NAME").doc("name of the result set"),
            Field::choice("output_type", &["displacement", "velocity", "acceleration", "force"])
                .doc("what is recorded of two markers"),
            common::I_MARKER,
            common::J_MARKER,
            Field::object("r_marker_name", "marker").keyword("RM").doc("marker along whose axes vectors are given"),
            fields::USER_FUNCTION,
            fields::ROUTINE,
            Field::function("f1").keyword("F1").doc("function of column 1"),
            Field::function("f2").keyword("F2").doc("function of column 2"),
            Field::function("f3").keyword("F3").doc("function of column 3"),
            Field::function("f4").keyword("F4").doc("function of column 4"),
            Field::function("f5").keyword("F5").doc("function of column 5"),
            Field::function("f6").keyword("F6").doc("function of column 6"),
            Field::function("f7").keyword("F7").doc("function of column 7"),
            Field::function("f8").keyword("F8").doc("function of column 8"),
            Field::texts("component_units").keyword("CUNITS").doc("units of the columns"),
            Field::texts("title").keyword("TITLE").doc("headings of the columns"),
            Field::object("motion_rframe", "marker").doc("frame in which time derivatives are taken"),
            Field::objects("variable_name", "solver_variable").keyword("VARIABLES").doc("solver variables recorded"),
        ],
        rules: &[],
        doc: "what is recorded during a run",
    }],
};
