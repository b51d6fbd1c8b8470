//! Names, types, units and defaults of a polyline.

use schema::{Class, Count, Dimension, Field, Group, Kind};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "polyline",
    word: "Polyline",
    families: &["geometry", "curve"],
    parents: &["part", "ground", "point_mass"],
    prefix: "POLYLINE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve polyline",
            creates: true,
            object: "polyline_name",
            fields: &[
                common::COMMENTS,
                Field::new("location", Kind::Location)
                    .dimension(Dimension::LENGTH)
                    .count(Count::between(3, usize::MAX))
                    .doc("points in order, in the frame of the body"),
                Field::yes_no("close").doc("whether and how the outline is closed"),
                Field::texts("path_curve").doc("curves the line follows"),
                Field::text("image_file_name").doc("picture painted on the inside"),
                Field::choice("horizontal", &["clamp", "repeat"]).doc("how the picture repeats across"),
                Field::choice("vertical", &["clamp", "repeat"]).doc("how the picture repeats upwards"),
                common::RELATIVE_TO,
            ],
            rules: &[],
            doc: "a line through points of the body",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
