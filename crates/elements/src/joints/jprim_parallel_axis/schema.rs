//! Names, types, units and defaults of the primitive joint parallel_axis.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "jprim_parallel_axis",
    word: "Joint_Primitive",
    families: &["primitive_joint", "constraint"],
    parents: &["model"],
    prefix: "JPRIM_",
    statement: Some("JPRIM"),
    groups: &[
        Group {
            command: "constraint create primitive_joint parallel_axis",
            creates: true,
            object: "jprim_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps z of I parallel to z of J",
        },
        attributes::CONSTRAINT,
    ],
};
