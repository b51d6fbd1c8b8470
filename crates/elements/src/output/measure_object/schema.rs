//! Names, types, units and defaults of an object measure.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "measure_object",
    word: "Measure",
    families: &["measure", "data_element"],
    parents: &["model"],
    prefix: "MEASURE_",
    statement: Some("REQUEST"),
    groups: &[
        Group {
            command: "measure create object",
            creates: true,
            object: "measure_name",
            fields: &[
                common::COMMENTS,
                Field::yes_no("from_first").default_word("no").doc("measured from the first to the second marker"),
                Field::object("object", "any").required().doc("object that is observed"),
                Field::text("characteristic").required().doc("quantity recorded"),
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
            doc: "a quantity of one object",
        },
        attributes::DATA_ELEMENT,
    ],
};
