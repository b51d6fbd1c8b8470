//! Names, types, units and defaults of the primitive joint inline.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "jprim_inline",
    word: "Joint_Primitive",
    families: &["primitive_joint", "constraint"],
    parents: &["model"],
    prefix: "JPRIM_",
    statement: Some("JPRIM"),
    groups: &[
        Group {
            command: "constraint create primitive_joint inline",
            creates: true,
            object: "jprim_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps I on the z axis of J",
        },
        attributes::CONSTRAINT,
    ],
};
