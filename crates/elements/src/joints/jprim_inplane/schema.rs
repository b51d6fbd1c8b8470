//! Names, types, units and defaults of the primitive joint inplane.

use schema::{Class, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "jprim_inplane",
    word: "Joint_Primitive",
    families: &["primitive_joint", "constraint"],
    parents: &["model"],
    prefix: "JPRIM_",
    statement: Some("JPRIM"),
    groups: &[
        Group {
            command: "constraint create primitive_joint inplane",
            creates: true,
            object: "jprim_name",
            fields: common::BETWEEN_MARKERS,
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps I in the xy plane of J",
        },
        attributes::CONSTRAINT,
    ],
};
