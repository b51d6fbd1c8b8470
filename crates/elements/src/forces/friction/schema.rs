//! Names, types, units and defaults of friction in a joint.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "friction",
    word: "Friction",
    families: &["force", "element_like"],
    parents: &["model"],
    prefix: "FRICTION_",
    statement: Some("FRICTION"),
    groups: &[
        Group {
            command: "force create element_like friction",
            creates: true,
            object: "friction_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("joint_name", "joint").required().keyword("JOINT").doc("joint in which friction acts"),
                Field::real("mu_static", Dimension::NONE)
                    .keyword("MU_STATIC")
                    .required()
                    .at_least(0.0)
                    .doc("friction coefficient at rest"),
                Field::real("mu_dynamic", Dimension::NONE)
                    .keyword("MU_DYNAMIC")
                    .required()
                    .at_least(0.0)
                    .doc("friction coefficient while sliding"),
                Field::real("friction_arm", Dimension::LENGTH)
                    .keyword("FRICTION_ARM")
                    .doc("arm at which friction makes torque about the axis"),
                Field::real("reaction_arm", Dimension::LENGTH)
                    .keyword("REACTION_ARM")
                    .doc("arm that turns torque about the axis into load on the surfaces"),
                Field::real("bending_reaction_arm", Dimension::LENGTH)
                    .keyword("BENDING_REACTION_ARM")
                    .doc("arm that turns bending into load on the surfaces"),
                Field::real("pin_radius", Dimension::LENGTH).keyword("PIN_RADIUS").doc("radius of the pin"),
                Field::real("ball_radius", Dimension::LENGTH).keyword("BALL_RADIUS").doc("radius of the ball"),
                Field::real("initial_overlap", Dimension::LENGTH)
                    .keyword("INITIAL_OVERLAP")
                    .doc("overlap of the sliding parts at the start"),
                Field::choice("formulation", &["original", "lugre"]).keyword("FORMULATION").doc("law of friction"),
                Field::real("stiction_transition_velocity", Dimension::VELOCITY)
                    .keyword("STICTION_TRANSITION_VELOCITY")
                    .doc("speed below which friction holds"),
                Field::real("transition_velocity_coefficient", Dimension::NONE)
                    .keyword("TRANSITION_VELOCITY_COEFFICIENT")
                    .doc("ratio of the speed of full sliding to that of full stiction"),
                Field::real("max_stiction_deformation", Dimension::LENGTH)
                    .keyword("MAX_STICTION_DEFORMATION")
                    .doc("creep while friction holds"),
                Field::real("bristle_stiffness_coefficient", Dimension::NONE)
                    .doc("stiffness of the bristles of the LuGre law"),
                Field::real("damping_coefficient", Dimension::NONE).doc("damping of the bristles of the LuGre law"),
                Field::real("viscous_friction_coefficient", Dimension::NONE).doc("viscous part of the LuGre law"),
                Field::real("velocity_threshold_stribeck", Dimension::NONE)
                    .doc("speed at which the Stribeck effect fades"),
                Field::real("decay_exponent_stribeck", Dimension::NONE)
                    .doc("exponent with which the Stribeck effect fades"),
                Field::real("friction_force_preload", Dimension::FORCE)
                    .keyword("FRICTION_FORCE_PRELOAD")
                    .doc("friction force without load"),
                Field::real("friction_torque_preload", Dimension::TORQUE)
                    .keyword("FRICTION_TORQUE_PRELOAD")
                    .doc("friction torque without load"),
                Field::real("max_friction_force", Dimension::FORCE)
                    .keyword("MAX_FRICTION_FORCE")
                    .doc("largest friction force"),
                Field::real("max_friction_torque", Dimension::TORQUE)
                    .keyword("MAX_FRICTION_TORQUE")
                    .doc("largest friction torque"),
                Field::choice("overlap_delta", &["increase", "decrease", "constant"])
                    .keyword("OVERLAP_DELTA")
                    .doc("how the overlap changes as the joint moves"),
                Field::real("bending_factor", Dimension::NONE).doc("factor on the load from bending"),
                Field::choice("effect", &["all", "stiction", "sliding"])
                    .keyword("EFFECT")
                    .doc("which parts of friction act"),
                Field::on_off("preload").doc("whether the preload makes friction"),
                Field::on_off("reaction_force").doc("whether the force in the joint makes friction"),
                Field::on_off("torsional_moment").doc("whether torque about the axis makes friction"),
                Field::on_off("bending_moment").doc("whether bending makes friction"),
                Field::on_off("inactive_during_static").doc("whether static analyses go without friction"),
                Field::choice("yoke", &["i_yoke", "j_yoke"])
                    .keyword("YOKE")
                    .doc("which yoke of a universal joint rubs"),
            ],
            rules: &[],
            doc: "friction in a joint",
        },
        attributes::FORCE,
    ],
};
