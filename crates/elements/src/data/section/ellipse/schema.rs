//! Names, types, units and formulas of the section of a solid ellipse. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_ellipse",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create ellipse",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::WIDTH.required(),
            fields::HEIGHT.required(),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("PI * @.width * @.height / 4"),
            fields::IYY.formula("PI * @.width * @.height**3 / 64"),
            fields::IZZ.formula("PI * @.height * @.width**3 / 64"),
            fields::IXX.formula("PI * @.width**3 * @.height**3 / (16 * (@.width**2 + @.height**2))"),
            fields::Y_SHEAR
                .formula("SECTION_SHEAR(\"ellipse\", \"y\", @.shear_theory, @.poisson_ratio, @.width, @.height)"),
            fields::Z_SHEAR
                .formula("SECTION_SHEAR(\"ellipse\", \"z\", @.shear_theory, @.poisson_ratio, @.width, @.height)"),
            fields::Y_EXTREME.formula("@.width / 2"),
            fields::Z_EXTREME.formula("@.height / 2"),
        ],
        rules: &[],
        doc: "the cross section of a solid ellipse for beams (an extension of Flexure)",
    }],
};
