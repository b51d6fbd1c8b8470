//! Names, types and units of a section of which only numbers are known.

use schema::{Class, Group};

use crate::{common, data::section::fields};

pub const CLASS: Class = Class {
    id: "section_properties",
    word: "Section",
    families: &["section"],
    parents: &["model"],
    prefix: "SECTION_",
    statement: None,
    groups: &[Group {
        command: "section create properties",
        creates: true,
        object: "section_name",
        fields: &[
            common::COMMENTS,
            fields::AREA.required(),
            fields::IYY.required(),
            fields::IZZ.required(),
            fields::IXX.required(),
            fields::Y_SHEAR.default(0.0),
            fields::Z_SHEAR.default(0.0),
            fields::Y_EXTREME,
            fields::Z_EXTREME,
        ],
        rules: &[],
        doc: "a cross section given by its properties, for beams (an extension of Flexure)",
    }],
};
