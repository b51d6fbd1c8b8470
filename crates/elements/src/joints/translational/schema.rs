//! Names, types, units and defaults of a translational joint.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_translational",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint translational",
            creates: true,
            object: "joint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("delta_v", Dimension::NONE).doc("velocity at which friction is full"),
                Field::real("maximum_deformation", Dimension::NONE).doc("creep before friction is full"),
                Field::real("mu_dyn_trans", Dimension::NONE).doc("friction coefficient while sliding"),
                Field::real("mu_stat_trans", Dimension::NONE).doc("friction coefficient at rest, sliding"),
                Field::real("max_fric_trans", Dimension::FORCE).doc("largest friction force"),
                Field::real("preload_x", Dimension::FORCE).doc("preload along x"),
                Field::real("preload_y", Dimension::FORCE).doc("preload along y"),
                Field::real("height", Dimension::LENGTH).doc("height of the slide"),
                Field::real("width", Dimension::LENGTH).doc("width of the slide"),
                Field::real("translational_ic", Dimension::LENGTH).doc("start displacement of the joint"),
                Field::true_false("no_translational_ic").doc("forget the start displacement"),
                Field::real("velocity_ic", Dimension::VELOCITY).doc("start velocity"),
                Field::true_false("no_velocity_ic").doc("forget the start velocity"),
                Field::choice("friction_enabled", &["yes", "no", "preload_only"])
                    .default_word("no")
                    .doc("whether friction acts, or its preload alone"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "lets I slide along z of J",
        },
        attributes::CONSTRAINT,
    ],
};
