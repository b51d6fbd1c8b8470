//! Names, types, units and defaults of a Hooke joint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_hooke",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint hooke",
            creates: true,
            object: "joint_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps two origins together and x of I perpendicular to y of J",
        },
        attributes::CONSTRAINT,
    ],
};
