//! Names, types, units and defaults of a measure of an angle.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_angle",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create angle",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::object("first_point", "marker").required().doc("end of the first line"),
                Field::object("middle_point", "marker").required().doc("vertex"),
                Field::object("last_point", "marker").required().doc("end of the second line"),
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "angle between the lines from a vertex to two markers",
        },
        attributes::DATA_ELEMENT,
    ],
};
