//! Names, types, units and defaults of a planar joint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_planar",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint planar",
            creates: true,
            object: "joint_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps I in the xy plane of J, turning about its z",
        },
        attributes::CONSTRAINT,
    ],
};
