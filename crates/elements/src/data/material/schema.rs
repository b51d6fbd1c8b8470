//! Names, types, units and defaults of a material.

use schema::{Class, Count, Dimension, Field, Group};

use crate::common;

pub const CLASS: Class = Class {
    id: "material",
    word: "Material",
    families: &[],
    parents: &["model"],
    prefix: "MATERIAL_",
    statement: None,
    groups: &[Group {
        command: "material create",
        creates: true,
        object: "material_name",
        fields: &[
            common::ADAMS_ID,
            common::COMMENTS,
            Field::real("density", Dimension::DENSITY).required().at_least(0.0).doc("mass per volume"),
            Field::real("youngs_modulus", Dimension::PRESSURE).doc("modulus of elasticity"),
            Field::real("poissons_ratio", Dimension::NONE).doc("lateral contraction ratio"),
            Field::real("orthotropic_constants", Dimension::PRESSURE)
                .count(Count::exactly(3))
                .doc("constants of an orthotropic material"),
            Field::real("anisotropic_constants", Dimension::PRESSURE)
                .count(Count::exactly(9))
                .doc("constants of an anisotropic material"),
        ],
        rules: &[],
        doc: "density and elastic constants",
    }],
};
