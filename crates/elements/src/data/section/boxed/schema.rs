//! Names, types, units and formulas of the section of a rectangular tube. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_box",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create box",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::WIDTH.required(),
            fields::HEIGHT.required(),
            fields::THICKNESS.required(),
            fields::FLANGE_THICKNESS.formula("@.thickness").doc("thickness of the walls across z; as `thickness` if not given"),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("@.width * @.height - (@.width - 2 * @.thickness) * (@.height - 2 * @.flange_thickness)"),
            fields::IYY.formula("(@.width * @.height**3 - (@.width - 2 * @.thickness) * (@.height - 2 * @.flange_thickness)**3) / 12"),
            fields::IZZ.formula("(@.height * @.width**3 - (@.height - 2 * @.flange_thickness) * (@.width - 2 * @.thickness)**3) / 12"),
            fields::IXX.formula("SECTION_TORSION(\"box\", @.width, @.height, @.thickness, @.flange_thickness)"),
            fields::Y_SHEAR.formula("SECTION_SHEAR(\"box\", \"y\", @.shear_theory, @.poisson_ratio, @.width, @.height, @.thickness, @.flange_thickness)"),
            fields::Z_SHEAR.formula("SECTION_SHEAR(\"box\", \"z\", @.shear_theory, @.poisson_ratio, @.width, @.height, @.thickness, @.flange_thickness)"),
            fields::Y_EXTREME.formula("@.width / 2"),
            fields::Z_EXTREME.formula("@.height / 2"),
        ],
        rules: &[],
        doc: "the cross section of a rectangular tube for beams (an extension of Flexure)",
    }],
};
