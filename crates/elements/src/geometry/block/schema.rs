//! Names, types, units and defaults of a block.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "block",
    word: "Block",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "BOX_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape block",
            creates: true,
            object: "block_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("corner_marker", "marker")
                    .required()
                    .keyword("CORNER")
                    .doc("marker at one corner, its axes run along the edges"),
                Field::real("diag_corner_coords", Dimension::LENGTH)
                    .count(Count::exactly(3))
                    .default(1.0)
                    .doc("coordinates of the opposite corner in the corner marker"),
            ],
            rules: &[],
            doc: "a box with one corner at a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
