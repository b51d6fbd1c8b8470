//! Names, types, units and defaults of a coupler.

use schema::{Class, Count, Dimension, Field, Group, Rule};

use crate::{attributes, common};

/// One word for each joint: it turns (`rot`) or slides (`tra`).
const FREEDOMS: &[&str] = &[
    "rot_rot",
    "rot_tra",
    "tra_rot",
    "tra_tra",
    "rot_rot_rot",
    "rot_rot_tra",
    "rot_tra_rot",
    "rot_tra_tra",
    "tra_rot_rot",
    "tra_rot_tra",
    "tra_tra_rot",
    "tra_tra_tra",
];

pub const CLASS: Class = Class {
    id: "coupler",
    word: "Coupler",
    families: &["constraint", "complex_joint"],
    parents: &["model"],
    prefix: "COUPLER_",
    statement: Some("COUPLER"),
    groups: &[
        Group {
            command: "constraint create complex_joint coupler",
            creates: true,
            object: "coupler_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("joint_name", "joint")
                    .count(Count::between(2, 3))
                    .required()
                    .keyword("JOINTS")
                    .doc("joints whose coordinates are coupled"),
                Field::choice("type_of_freedom", FREEDOMS).doc("whether each joint turns or slides, as one word"),
                Field::choice("freedom_type", &["translational", "rotational"])
                    .count(Count::exactly(2))
                    .doc("whether each joint turns or slides, as a list"),
                Field::real("motion_multipliers", Dimension::NONE)
                    .count(Count::between(2, 3))
                    .keyword("SCALES")
                    .doc("factors of the coordinates, whose sum is zero"),
                Field::real("first_angular_scale_factor", Dimension::ANGLE)
                    .default(0.0)
                    .doc("factor of the first joint as an angle"),
                Field::real("first_scale_factor", Dimension::NONE).default(0.0).doc("factor of the first joint"),
                Field::real("second_angular_scale_factor", Dimension::ANGLE)
                    .default(0.0)
                    .doc("factor of the second joint as an angle"),
                Field::real("second_scale_factor", Dimension::NONE).default(0.0).doc("factor of the second joint"),
                Field::real("third_angular_scale_factor", Dimension::ANGLE)
                    .default(0.0)
                    .doc("factor of the third joint as an angle"),
                Field::real("third_scale_factor", Dimension::NONE).default(0.0).doc("factor of the third joint"),
                common::USER_FUNCTION,
                common::ROUTINE,
                Field::real("driver_length", Dimension::LENGTH)
                    .default(0.0)
                    .doc("share of the driving joint as a length"),
                Field::real("driver_angle", Dimension::ANGLE)
                    .default(0.0)
                    .doc("share of the driving joint as an angle"),
                Field::real("slave_length", Dimension::LENGTH)
                    .default(0.0)
                    .doc("share of the driven joint as a length"),
                Field::real("slave_angle", Dimension::ANGLE).default(0.0).doc("share of the driven joint as an angle"),
                Field::real("slave1_length", Dimension::LENGTH)
                    .default(0.0)
                    .doc("share of the first driven joint as a length"),
                Field::real("slave1_angle", Dimension::ANGLE)
                    .default(0.0)
                    .doc("share of the first driven joint as an angle"),
                Field::real("slave2_length", Dimension::LENGTH)
                    .default(0.0)
                    .doc("share of the second driven joint as a length"),
                Field::real("slave2_angle", Dimension::ANGLE)
                    .default(0.0)
                    .doc("share of the second driven joint as an angle"),
            ],
            rules: &[Rule::AtMostOne(&["motion_multipliers", "user_function"])],
            doc: "keeps the coordinates of two or three joints proportional",
        },
        attributes::CONSTRAINT,
    ],
};
