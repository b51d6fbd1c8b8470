//! Names, types, units and defaults of a plane.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "plane",
    word: "Plane",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "PLANE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape plane",
            creates: true,
            object: "plane_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("ref_marker_name", "marker").required().doc("marker whose x and y lie in the plane"),
                Field::real("x_minimum", Dimension::LENGTH).required().doc("where it begins along x"),
                Field::real("x_maximum", Dimension::LENGTH).required().doc("where it ends along x"),
                Field::real("y_minimum", Dimension::LENGTH).required().doc("where it begins along y"),
                Field::real("y_maximum", Dimension::LENGTH).required().doc("where it ends along y"),
            ],
            rules: &[],
            doc: "a rectangle without thickness in the xy plane of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
