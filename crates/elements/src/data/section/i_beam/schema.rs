//! Names, types, units and formulas of the section of an I of two equal flanges. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_i",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create i",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::WIDTH.required(),
            fields::HEIGHT.required(),
            fields::WEB_THICKNESS.required(),
            fields::FLANGE_THICKNESS.required(),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("2 * @.width * @.flange_thickness + @.web_thickness * (@.height - 2 * @.flange_thickness)"),
            fields::IYY.formula("(@.width * @.height**3 - (@.width - @.web_thickness) * (@.height - 2 * @.flange_thickness)**3) / 12"),
            fields::IZZ.formula("(2 * @.flange_thickness * @.width**3 + (@.height - 2 * @.flange_thickness) * @.web_thickness**3) / 12"),
            fields::IXX.formula("SECTION_TORSION(\"i\", @.width, @.height, @.web_thickness, @.flange_thickness)"),
            fields::Y_SHEAR.formula("SECTION_SHEAR(\"i\", \"y\", @.shear_theory, @.poisson_ratio, @.width, @.height, @.web_thickness, @.flange_thickness)"),
            fields::Z_SHEAR.formula("SECTION_SHEAR(\"i\", \"z\", @.shear_theory, @.poisson_ratio, @.width, @.height, @.web_thickness, @.flange_thickness)"),
            fields::Y_EXTREME.formula("@.width / 2"),
            fields::Z_EXTREME.formula("@.height / 2"),
        ],
        rules: &[],
        doc: "the cross section of an I of two equal flanges for beams (an extension of Flexure)",
    }],
};
