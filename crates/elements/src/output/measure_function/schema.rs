//! Names, types, units and defaults of a function measure.

use schema::{Class, Field, Group};

use crate::{attributes, common, data::fields, output::measured};

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
                measured::LEGEND,
                measured::DISPLAY,
                fields::USER_FUNCTION,
                fields::ROUTINE,
            ],
            rules: &[],
            doc: "value of a function during the run",
        },
        attributes::DATA_ELEMENT,
    ],
};
