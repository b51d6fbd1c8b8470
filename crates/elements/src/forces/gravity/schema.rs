//! Names, types, units and defaults of gravity.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "gravity",
    word: "Gravity",
    families: &["force"],
    parents: &["model"],
    prefix: "GRAVITY_FIELD_",
    statement: Some("ACCGRAV"),
    groups: &[
        Group {
            command: "force create body gravitational",
            creates: true,
            object: "gravity_field_name",
            fields: &[
                common::COMMENTS,
                Field::real("x_component_gravity", Dimension::ACCELERATION)
                    .keyword("IGRAV")
                    .doc("acceleration along global x"),
                Field::real("y_component_gravity", Dimension::ACCELERATION)
                    .keyword("JGRAV")
                    .doc("acceleration along global y"),
                Field::real("z_component_gravity", Dimension::ACCELERATION)
                    .keyword("KGRAV")
                    .doc("acceleration along global z"),
                Field::real("units_consistency_factor", Dimension::NONE)
                    .doc("overrides the factor between force and mass times acceleration"),
            ],
            rules: &[],
            doc: "one acceleration for all bodies",
        },
        attributes::FORCE,
    ],
};
