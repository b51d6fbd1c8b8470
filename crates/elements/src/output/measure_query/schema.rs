//! Names, types, units and defaults of a measure that asks a dialog.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_query",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create query",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::text("gui_driver_name").doc("control of a dialog that is asked"),
                Field::real("delay_time", Dimension::TIME).doc("time between two questions"),
                Field::real("initial_condition", Dimension::NONE).doc("value before the first answer"),
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "value that a control of a dialog has",
        },
        attributes::DATA_ELEMENT,
    ],
};
