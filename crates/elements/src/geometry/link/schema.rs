//! Names, types, units and defaults of a link.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "link",
    word: "Link",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "LINK_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape link",
            creates: true,
            object: "link_name",
            fields: &[
                common::COMMENTS,
                Field::object("i_marker", "marker").required().doc("marker at the first end"),
                Field::object("j_marker", "marker").required().doc("marker at the second end"),
                Field::real("width", Dimension::LENGTH)
                    .required()
                    .doc("width of the bar and diameter of its round ends"),
                Field::real("depth", Dimension::LENGTH)
                    .required()
                    .doc("thickness across the plane of the bar, half of it on either side of the markers"),
            ],
            rules: &[],
            doc: "a bar with round ends between two markers",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
