//! Names, types, units and defaults of a universal joint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_universal",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint universal",
            creates: true,
            object: "joint_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps two origins together and the z axes perpendicular",
        },
        attributes::CONSTRAINT,
    ],
};
