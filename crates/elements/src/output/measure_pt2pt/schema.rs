//! Names, types, units and defaults of a point-to-point measure.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

pub const CLASS: Class = Class {
    id: "measure_pt2pt",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create pt2pt",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::object("from_point", "marker").doc("marker measured from; the global origin if not given"),
                Field::object("to_point", "marker").required().doc("marker measured to"),
                Field::choice(
                    "characteristic",
                    &[
                        "translational_displacement",
                        "translational_velocity",
                        "translational_acceleration",
                        "angular_velocity",
                        "angular_acceleration",
                    ],
                )
                .required()
                .doc("quantity recorded"),
                measured::COMPONENT,
                measured::MOTION_RFRAME,
                measured::COORDINATE_RFRAME,
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "motion of one marker as seen from another",
        },
        attributes::DATA_ELEMENT,
    ],
};
