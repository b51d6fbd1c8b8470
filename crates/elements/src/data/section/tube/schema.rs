//! Names, types, units and formulas of the section of a round tube. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_tube",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create tube",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::DIAMETER.required(),
            fields::THICKNESS.required(),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("PI * @.thickness * (@.diameter - @.thickness)"),
            fields::IYY.formula("PI * (@.diameter**4 - (@.diameter - 2 * @.thickness)**4) / 64"),
            fields::IZZ.formula("PI * (@.diameter**4 - (@.diameter - 2 * @.thickness)**4) / 64"),
            fields::IXX.formula("@.iyy + @.izz"),
            fields::Y_SHEAR
                .formula("SECTION_SHEAR(\"tube\", \"y\", @.shear_theory, @.poisson_ratio, @.diameter, @.thickness)"),
            fields::Z_SHEAR
                .formula("SECTION_SHEAR(\"tube\", \"z\", @.shear_theory, @.poisson_ratio, @.diameter, @.thickness)"),
            fields::Y_EXTREME.formula("@.diameter / 2"),
            fields::Z_EXTREME.formula("@.diameter / 2"),
        ],
        rules: &[],
        doc: "the cross section of a round tube for beams (an extension of Flexure)",
    }],
};
