//! Names, types, units and defaults of a measure of an orientation.

use schema::{Class, Field, Group};

use crate::{attributes, common, output::measured};

/// Angles, Euler and Rodriguez parameters, entries of the matrix of direction cosines.
const COMPONENTS: &[&str] = &[
    "angle_1_component",
    "angle_2_component",
    "angle_3_component",
    "param_1_component",
    "param_2_component",
    "param_3_component",
    "param_4_component",
    "mat_1_1_component",
    "mat_1_2_component",
    "mat_1_3_component",
    "mat_2_1_component",
    "mat_2_2_component",
    "mat_2_3_component",
    "mat_3_1_component",
    "mat_3_2_component",
    "mat_3_3_component",
];
const CONVENTIONS: &[&str] = &[
    "euler_angles",
    "yaw_pitch_roll",
    "ax_ay_az_projection_angles",
    "bryant_angles",
    "body_1_2_3",
    "body_2_3_1",
    "body_3_1_2",
    "body_1_3_2",
    "body_2_1_3",
    "body_3_2_1",
    "body_1_2_1",
    "body_1_3_1",
    "body_2_1_2",
    "body_2_3_2",
    "body_3_1_3",
    "body_3_2_3",
    "space_1_2_3",
    "space_2_3_1",
    "space_3_1_2",
    "space_1_3_2",
    "space_2_1_3",
    "space_3_2_1",
    "space_1_2_1",
    "space_1_3_1",
    "space_2_1_2",
    "space_2_3_2",
    "space_3_1_3",
    "space_3_2_3",
    "euler_parameters",
    "rodriguez_parameters",
    "direction_cosines",
];

pub const CLASS: Class = Class {
    id: "measure_orient",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create orient",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::choice("component", COMPONENTS).required().doc("which of the numbers is recorded"),
                Field::choice("characteristic", CONVENTIONS).required().doc("by which numbers turns are described"),
                Field::object("to_frame", "frame").required().doc("frame that is observed"),
                Field::object("from_frame", "frame").doc("frame it is seen from; the global one if not given"),
                measured::DISPLAY,
                measured::LEGEND,
            ],
            rules: &[],
            doc: "orientation of one frame as seen from another",
        },
        attributes::DATA_ELEMENT,
    ],
};
