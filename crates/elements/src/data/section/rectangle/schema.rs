//! Names, types, units and formulas of the section of a solid rectangle. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_rectangle",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create rectangle",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::WIDTH.required(),
            fields::HEIGHT.required(),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("@.width * @.height"),
            fields::IYY.formula("@.width * @.height**3 / 12"),
            fields::IZZ.formula("@.height * @.width**3 / 12"),
            fields::IXX.formula("SECTION_TORSION(\"rectangle\", @.width, @.height)"),
            fields::Y_SHEAR
                .formula("SECTION_SHEAR(\"rectangle\", \"y\", @.shear_theory, @.poisson_ratio, @.width, @.height)"),
            fields::Z_SHEAR
                .formula("SECTION_SHEAR(\"rectangle\", \"z\", @.shear_theory, @.poisson_ratio, @.width, @.height)"),
            fields::Y_EXTREME.formula("@.width / 2"),
            fields::Z_EXTREME.formula("@.height / 2"),
        ],
        rules: &[],
        doc: "the cross section of a solid rectangle for beams (an extension of Flexure)",
    }],
};
