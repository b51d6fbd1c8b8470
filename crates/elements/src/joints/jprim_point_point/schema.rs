//! Names, types, units and defaults of the primitive joint point_point.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "jprim_point_point",
    word: "Joint_Primitive",
    families: &["primitive_joint", "constraint"],
    parents: &["model"],
    prefix: "JPRIM_",
    statement: None,
    groups: &[
        Group {
            command: "constraint create primitive_joint point_point",
            creates: true,
            object: "jprim_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("offset", Dimension::LENGTH).doc("distance that is kept"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "keeps two points at a distance",
        },
        attributes::CONSTRAINT,
    ],
};
