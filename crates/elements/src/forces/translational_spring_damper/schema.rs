//! Names, types, units and defaults of a translational spring-damper.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "translational_spring_damper",
    word: "Spring_Damper",
    families: &["force", "element_like", "spring_damper"],
    parents: &["model"],
    prefix: "SPRING_DAMPER_",
    statement: Some("SPRINGDAMPER"),
    groups: &[
        Group {
            command: "force create element_like translational_spring_damper",
            creates: true,
            object: "spring_damper_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                common::J_MARKER,
                Field::real("damping", Dimension::DAMPING)
                    .default(0.0)
                    .keyword("C")
                    .doc("viscous damping along the line between the markers"),
                Field::real("stiffness", Dimension::STIFFNESS)
                    .default(1.0)
                    .keyword("K")
                    .doc("stiffness along the line between the markers"),
                Field::real("preload", Dimension::FORCE)
                    .default(0.0)
                    .keyword("FORCE")
                    .doc("force at the reference distance"),
                Field::real("displacement_at_preload", Dimension::LENGTH)
                    .default(0.0)
                    .keyword("LENGTH")
                    .doc("reference distance, at which the force is the preload"),
                common::I_PART,
                common::J_PART,
                common::LOCATION.on_create(),
                common::ORIENTATION.on_create(),
                common::ALONG_AXIS_ORIENTATION.on_create(),
                common::IN_PLANE_ORIENTATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: &[
                Rule::AtMostOne(&["i_marker_name", "i_part_name"]),
                Rule::AtMostOne(&["j_marker_name", "j_part_name"]),
                common::ONE_ORIENTATION,
            ],
            doc: "a spring and damper along the line between the markers",
        },
        attributes::FORCE,
    ],
};
