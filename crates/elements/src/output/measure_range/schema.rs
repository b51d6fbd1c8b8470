//! Names, types, units and defaults of a measure of the range of another.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_range",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create range",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::choice(
                    "type",
                    &["minimum", "maximum", "average", "variation", "same_as", "absolute_minimum", "absolute_maximum"],
                )
                .required()
                .doc("what is kept of the other measure"),
                Field::object("of_measure_name", "measure").required().doc("measure that is observed"),
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "what another measure has been at least, at most or on average",
        },
        attributes::DATA_ELEMENT,
    ],
};
