//! Names, types, units and defaults of a torus.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "torus",
    word: "Torus",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "TORUS_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape torus",
            creates: true,
            object: "torus_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker")
                    .required()
                    .keyword("CM")
                    .doc("marker at the centre, z is the axis"),
                Field::real("angle_extent", Dimension::ANGLE)
                    .doc("swept angle from x towards y; a full turn if not given"),
                Field::real("major_radius", Dimension::LENGTH).default(2.0).doc("radius of the ring"),
                Field::real("minor_radius", Dimension::LENGTH).default(1.0).doc("radius of the tube"),
                Field::integer("side_count_for_perimeter").default(20.0).doc("sides of the tube drawn"),
                Field::integer("segment_count").default(20.0).doc("pieces drawn along the ring"),
            ],
            rules: &[],
            doc: "a ring around z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
