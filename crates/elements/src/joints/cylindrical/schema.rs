//! Names, types, units and defaults of a cylindrical joint.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_cylindrical",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint cylindrical",
            creates: true,
            object: "joint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("translational_ic", Dimension::LENGTH).doc("start displacement of the joint"),
                Field::true_false("no_translational_ic").doc("forget the start displacement"),
                Field::real("velocity_ic", Dimension::VELOCITY).doc("start velocity"),
                Field::true_false("no_velocity_ic").doc("forget the start velocity"),
                Field::real("rotational_ic", Dimension::ANGLE).doc("start angle of the joint"),
                Field::true_false("no_rotational_ic").doc("forget the start angle"),
                Field::real("angular_velocity_ic", Dimension::ANGULAR_VELOCITY)
                    .doc("start angular velocity of the joint"),
                Field::true_false("no_angular_velocity_ic").doc("forget the start angular velocity"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "lets I slide along and turn about z of J",
        },
        attributes::CONSTRAINT,
    ],
};
