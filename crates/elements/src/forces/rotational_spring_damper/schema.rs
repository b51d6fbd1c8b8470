//! Names, types, units and defaults of a rotational spring-damper.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "rotational_spring_damper",
    word: "Spring_Damper",
    families: &["force", "element_like", "spring_damper"],
    parents: &["model"],
    prefix: "SPRING_DAMPER_",
    statement: Some("SPRINGDAMPER"),
    groups: &[
        Group {
            command: "force create element_like rotational_spring_damper",
            creates: true,
            object: "spring_damper_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("damping", Dimension::TORSION_DAMPING)
                    .default(0.0)
                    .keyword("CT")
                    .doc("viscous damping about the common z axis"),
                Field::real("stiffness", Dimension::TORSION_STIFFNESS)
                    .default(1.0)
                    .keyword("KT")
                    .doc("stiffness about the common z axis"),
                Field::real("preload", Dimension::TORQUE)
                    .default(0.0)
                    .keyword("TORQUE")
                    .doc("torque at the reference angle"),
                Field::real("displacement_at_preload", Dimension::ANGLE)
                    .default(0.0)
                    .keyword("ANGLE")
                    .doc("reference angle, at which the torque is the preload"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: common::MARKERS_OR_PARTS,
            doc: "a spring and damper about the common z axis",
        },
        attributes::FORCE,
    ],
};
