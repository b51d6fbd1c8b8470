//! Names, types, units and defaults of a constant-velocity joint.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_convel",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint convel",
            creates: true,
            object: "joint_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "makes two shafts at an angle turn alike",
        },
        attributes::CONSTRAINT,
    ],
};
