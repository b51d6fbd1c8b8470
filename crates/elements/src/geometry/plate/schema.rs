//! Names, types, units and defaults of a plate.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "plate",
    word: "Plate",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "PLATE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape plate",
            creates: true,
            object: "plate_name",
            fields: &[
                common::COMMENTS,
                Field::object("marker_name", "marker")
                    .count(Count::between(3, usize::MAX))
                    .required()
                    .doc("markers at the centres of the round corners, in order around the plate"),
                Field::real("width", Dimension::LENGTH).required().doc("thickness of the plate"),
                Field::real("radius", Dimension::LENGTH).required().doc("radius of the round corners"),
            ],
            rules: &[],
            doc: "a plate with round corners around three or more markers",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
