//! Names, types, units and defaults of a gear pair.

use schema::{Class, Count, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "gear",
    word: "Gear",
    families: &["constraint", "complex_joint"],
    parents: &["model"],
    prefix: "GEAR_",
    statement: Some("GEAR"),
    groups: &[
        Group {
            command: "constraint create complex_joint gear",
            creates: true,
            object: "gear_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("joint_name", "joint")
                    .count(Count::exactly(2))
                    .required()
                    .keyword("JOINTS")
                    .doc("joints of the two wheels with their common carrier"),
                Field::object("common_velocity_marker", "marker")
                    .required()
                    .keyword("CV")
                    .doc("marker where the wheels touch, on the carrier, with z along their common velocity"),
            ],
            rules: &[],
            doc: "makes two wheels share the velocity of the point where they touch",
        },
        attributes::CONSTRAINT,
    ],
};
