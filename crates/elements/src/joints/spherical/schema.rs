//! Names, types, units and defaults of a spherical joint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_spherical",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint spherical",
            creates: true,
            object: "joint_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps two origins together",
        },
        attributes::CONSTRAINT,
    ],
};
