//! Names, types, units and defaults of a point that is geometry.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "geometry_point",
    word: "Geometry_Point",
    families: &["geometry"],
    parents: &["part", "ground", "point_mass"],
    prefix: "POINT_GEOMETRY_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create point",
            creates: true,
            object: "point_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("ref_marker_name", "marker").required().doc("marker at which the point is"),
            ],
            rules: &[],
            doc: "a dot at a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
