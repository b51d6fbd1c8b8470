//! Names, types, units and defaults of a function measure.

use schema::{Class, Field, Group, Kind};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "measure_function",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create function",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::function("function").doc("function of time and state, evaluated during the run"),
                Field::text("units").doc("kind of quantity of the value"),
                Field::text("legend").doc("text of the legend"),
                Field::yes_no("create_measure_display").default_word("yes").on_create().doc("open a strip chart"),
                Field::new("user_function", Kind::Real).many().doc("constants handed to a subroutine"),
                Field::text("routine").doc("library and entry of the subroutine"),
            ],
            rules: &[],
            doc: "value of a function during the run",
        },
        attributes::DATA_ELEMENT,
    ],
};
