//! Names, types, units and defaults of an outline.

use schema::{Class, Count, Field, Group};

use crate::{attributes, common, geometry::fields};

pub const CLASS: Class = Class {
    id: "outline",
    word: "Outline",
    families: &["geometry", "curve", "wire"],
    parents: &["part", "ground", "point_mass"],
    prefix: "OUTLINE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve outline",
            creates: true,
            object: "outline_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("marker_name", "marker")
                    .count(Count::between(2, usize::MAX))
                    .required()
                    .doc("markers that are joined, in order"),
                Field::choice("visibility_between_markers", &["on", "off"])
                    .many()
                    .doc("which of the pieces are drawn; all if not given"),
                fields::IMAGE_FILE_NAME,
                fields::HORIZONTAL,
                fields::VERTICAL,
                Field::yes_no("close").default_word("no").doc("join the last marker with the first"),
            ],
            rules: &[],
            doc: "straight lines from marker to marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
