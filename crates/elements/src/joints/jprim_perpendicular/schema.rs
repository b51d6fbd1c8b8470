//! Names, types, units and defaults of the primitive joint perpendicular.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "jprim_perpendicular",
    word: "Joint_Primitive",
    families: &["primitive_joint", "constraint"],
    parents: &["model"],
    prefix: "JPRIM_",
    statement: Some("JPRIM"),
    groups: &[
        Group {
            command: "constraint create primitive_joint perpendicular",
            creates: true,
            object: "jprim_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps z of I perpendicular to z of J",
        },
        attributes::CONSTRAINT,
    ],
};
