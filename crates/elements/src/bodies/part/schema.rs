//! Names, types, units and defaults of a rigid part.

use schema::Class;

use crate::{attributes, bodies::rigid_body};

pub const CLASS: Class = Class {
    id: "part",
    word: "Part",
    families: &["part", "body", "frame", "rigid_body"],
    parents: &["model"],
    prefix: "PART_",
    statement: Some("PART"),
    groups: &[
        rigid_body::NAME_AND_POSITION,
        rigid_body::MASS_PROPERTIES,
        rigid_body::INITIAL_VELOCITY,
        attributes::PART,
    ],
};
