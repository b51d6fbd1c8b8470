//! Names, types, units and defaults of a circle.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "circle",
    word: "Circle",
    families: &["geometry", "curve", "wire"],
    parents: &["part", "ground", "point_mass"],
    prefix: "CIRCLE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve circle",
            creates: true,
            object: "circle_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker")
                    .required()
                    .keyword("CM")
                    .doc("marker at the centre, z is the axis"),
                Field::real("radius", Dimension::LENGTH).default(1.0).keyword("RADIUS").doc("radius"),
                Field::integer("segment_count").default(20.0).doc("pieces drawn along the curve"),
                Field::object("ref_radius_by_marker", "marker")
                    .doc("marker through which the outline passes; it sets the radius"),
            ],
            rules: &[],
            doc: "a circle around z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
