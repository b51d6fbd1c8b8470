//! Names, types, units and formulas of the section of a solid circle. What the formulas are, with their
//! sources, stands in the room `sections`.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_circle",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create circle",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::DIAMETER.required(),
            fields::POISSON_RATIO,
            fields::SHEAR_THEORY,
            fields::AREA.formula("PI * @.diameter**2 / 4"),
            fields::IYY.formula("PI * @.diameter**4 / 64"),
            fields::IZZ.formula("PI * @.diameter**4 / 64"),
            fields::IXX.formula("@.iyy + @.izz"),
            fields::Y_SHEAR.formula("SECTION_SHEAR(\"circle\", \"y\", @.shear_theory, @.poisson_ratio, @.diameter)"),
            fields::Z_SHEAR.formula("SECTION_SHEAR(\"circle\", \"z\", @.shear_theory, @.poisson_ratio, @.diameter)"),
            fields::Y_EXTREME.formula("@.diameter / 2"),
            fields::Z_EXTREME.formula("@.diameter / 2"),
        ],
        rules: &[],
        doc: "the cross section of a solid circle for beams (an extension of Flexure)",
    }],
};
