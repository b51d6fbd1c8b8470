//! Names, types, units and defaults of an ellipsoid.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "ellipsoid",
    word: "Ellipsoid",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "ELLIPSOID_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape ellipsoid",
            creates: true,
            object: "ellipsoid_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker").required().keyword("CM").doc("marker at the centre"),
                Field::real("x_scale_factor", Dimension::LENGTH).default(1.0).keyword("XSCALE").doc("diameter along x"),
                Field::real("y_scale_factor", Dimension::LENGTH).default(1.0).keyword("YSCALE").doc("diameter along y"),
                Field::real("z_scale_factor", Dimension::LENGTH).default(1.0).keyword("ZSCALE").doc("diameter along z"),
            ],
            rules: &[],
            doc: "an ellipsoid around a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
