//! Names, types, units and defaults of the ground.

use schema::{Class, Group};

use crate::{attributes, bodies::rigid_body};

pub const CLASS: Class = Class {
    id: "ground",
    word: "Part",
    families: &["part", "body", "frame"],
    parents: &["model"],
    prefix: "GROUND_",
    statement: Some("PART"),
    groups: &[
        Group {
            command: "part create new_ground",
            creates: true,
            object: "part_name",
            fields: &[],
            rules: &[],
            doc: "another ground part",
        },
        rigid_body::of_ground(rigid_body::NAME_AND_POSITION),
        rigid_body::of_ground(rigid_body::MASS_PROPERTIES),
        rigid_body::of_ground(rigid_body::INITIAL_VELOCITY),
        attributes::PART,
    ],
};
