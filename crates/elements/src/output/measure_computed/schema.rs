//! Names, types, units and defaults of a measure computed from others.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_computed",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create computed",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::function("text_of_expression").required().doc("expression over measures and variables"),
                Field::text("units").doc("kind of quantity of the value"),
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "value of an expression over other measures",
        },
        attributes::DATA_ELEMENT,
    ],
};
