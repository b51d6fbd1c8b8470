//! Names, types, units and defaults of a rack and pinion.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_rackpin",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint rackpin",
            creates: true,
            object: "joint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("diameter_of_pitch", Dimension::LENGTH)
                    .required()
                    .keyword("PD")
                    .doc("pitch diameter of the pinion, whose sign says which way the rack moves"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "makes a rack move as a pinion turns",
        },
        attributes::CONSTRAINT,
    ],
};
