//! Names, types, units and defaults of a polyline.

use schema::{Class, Count, Dimension, Field, Group, Kind};

use crate::{attributes, common, geometry::fields};

pub const CLASS: Class = Class {
    id: "polyline",
    word: "Polyline",
    families: &["geometry", "curve", "wire"],
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
                Field::objects("path_curve", "wire").doc("curves the line follows"),
                fields::IMAGE_FILE_NAME,
                fields::HORIZONTAL,
                fields::VERTICAL,
                common::RELATIVE_TO,
            ],
            rules: &[],
            doc: "a line through points of the body",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
