//! Names, types, units and defaults of a screw joint.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_screw",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint screw",
            creates: true,
            object: "joint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("pitch", Dimension::LENGTH)
                    .required()
                    .keyword("PITCH")
                    .doc("travel along z of J in one turn"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "makes I move along z of J as it turns",
        },
        attributes::CONSTRAINT,
    ],
};
