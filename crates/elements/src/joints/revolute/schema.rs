//! Names, types, units and defaults of a revolute joint.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "joint_revolute",
    word: "Joint",
    families: &["joint", "constraint"],
    parents: &["model"],
    prefix: "JOINT_",
    statement: Some("JOINT"),
    groups: &[
        Group {
            command: "constraint create joint revolute",
            creates: true,
            object: "joint_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("delta_v", Dimension::NONE).doc("velocity at which friction is full"),
                Field::real("maximum_deformation", Dimension::NONE).doc("creep before friction is full"),
                Field::real("mu_dyn_rot", Dimension::NONE).doc("friction coefficient while turning"),
                Field::real("mu_stat_rot", Dimension::NONE).doc("friction coefficient at rest, turning"),
                Field::real("max_fric_rot", Dimension::TORQUE).doc("largest friction torque"),
                Field::real("preload_radial", Dimension::FORCE).doc("radial preload"),
                Field::real("preload_axial", Dimension::FORCE).doc("axial preload"),
                Field::real("inner_radius", Dimension::LENGTH).doc("inner radius of the bearing"),
                Field::real("outer_radius", Dimension::LENGTH).doc("outer radius of the bearing"),
                Field::real("rotational_ic", Dimension::ANGLE).doc("start angle of the joint"),
                Field::true_false("no_rotational_ic").doc("forget the start angle"),
                Field::real("angular_velocity_ic", Dimension::ANGULAR_VELOCITY)
                    .doc("start angular velocity of the joint"),
                Field::true_false("no_angular_velocity_ic").doc("forget the start angular velocity"),
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
            doc: "lets I turn about z of J",
        },
        attributes::CONSTRAINT,
    ],
};
