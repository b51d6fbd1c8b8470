//! Names, types, units and defaults of a point-to-point measure.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "measure_pt2pt",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create pt2pt",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::object("from_point", "marker").doc("marker measured from; the global origin if not given"),
                Field::object("to_point", "marker").required().doc("marker measured to"),
                Field::choice(
                    "characteristic",
                    &[
                        "translational_displacement",
                        "translational_velocity",
                        "translational_acceleration",
                        "angular_velocity",
                        "angular_acceleration",
                    ],
                )
                .required()
                .doc("quantity recorded"),
                Field::choice(
                    "component",
                    &[
                        "x_component",
                        "y_component",
                        "z_component",
                        "mag_component",
                        "r_component",
                        "rho_component",
                        "theta_component",
                        "phi_component",
                    ],
                )
                .required()
                .doc("component recorded"),
                Field::object("motion_rframe", "marker").doc("frame in which time derivatives are taken"),
                Field::object("coordinate_rframe", "marker").doc("marker along whose axes components are given"),
                Field::yes_no("create_measure_display").default_word("yes").on_create().doc("open a strip chart"),
                Field::text("legend").doc("text of the legend"),
            ],
            rules: &[],
            doc: "motion of one marker as seen from another",
        },
        attributes::DATA_ELEMENT,
    ],
};
