//! Names, types, units and defaults of a measure of a point.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_point",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create point",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::object("point", "marker").required().doc("marker that is observed"),
                Field::text("characteristic").required().doc("quantity recorded"),
                measured::COMPONENT,
                measured::MOTION_RFRAME,
                measured::COORDINATE_RFRAME,
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "motion of a marker, or load on it, in the global frame",
        },
        attributes::DATA_ELEMENT,
    ],
};
