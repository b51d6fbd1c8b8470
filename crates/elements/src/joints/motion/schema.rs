//! Names, types, units and defaults of a motion.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "motion",
    word: "Motion",
    families: &["constraint"],
    parents: &["model"],
    prefix: "MOTION_",
    statement: Some("MOTION"),
    groups: &[
        Group {
            command: "constraint create motion_generator",
            creates: true,
            object: "motion_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::choice("type_of_freedom", &["translational", "rotational"])
                    .doc("whether it moves along or turns about the axis"),
                Field::object("joint_name", "joint").keyword("JOINT").doc("joint that is driven"),
                common::I_MARKER,
                common::J_MARKER,
                Field::choice("axis", &["x", "y", "z", "b1", "b2", "b3"]).doc("coordinate that is driven"),
                Field::choice("time_derivative", &["displacement", "velocity", "acceleration"])
                    .default_word("displacement")
                    .doc("which time derivative the function prescribes"),
                common::FUNCTION,
                common::USER_FUNCTION,
                common::ROUTINE,
                Field::real("displacement_ic", Dimension::LENGTH)
                    .keyword("ICDISP")
                    .doc("start displacement where a derivative is prescribed"),
                Field::real("velocity_ic", Dimension::VELOCITY).keyword("ICVEL").doc("start velocity"),
                Field::real("rotational_displacement_ic", Dimension::ANGLE)
                    .doc("start angle where a derivative is prescribed"),
                Field::real("rotational_velocity_ic", Dimension::ANGULAR_VELOCITY)
                    .doc("start angular velocity where the acceleration is prescribed"),
            ],
            rules: &[
                Rule::AtMostOne(&["function", "user_function"]),
                Rule::AtLeastOne(&["function", "user_function"]),
                Rule::AtMostOne(&["joint_name", "i_marker_name"]),
                Rule::AtMostOne(&["joint_name", "j_marker_name"]),
                Rule::AtLeastOne(&["joint_name", "i_marker_name"]),
                Rule::AtLeastOne(&["joint_name", "j_marker_name"]),
            ],
            doc: "drives a joint, or one coordinate between two markers, by a function",
        },
        attributes::CONSTRAINT,
    ],
};
