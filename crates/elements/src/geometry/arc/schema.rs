//! Names, types, units and defaults of an arc.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "arc",
    word: "Arc",
    families: &["geometry", "curve", "wire"],
    parents: &["part", "ground", "point_mass"],
    prefix: "ARC_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve arc",
            creates: true,
            object: "arc_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker")
                    .required()
                    .keyword("CM")
                    .doc("marker at the centre, z is the axis"),
                Field::real("angle_extent", Dimension::ANGLE)
                    .doc("swept angle from x towards y; a quarter turn if not given"),
                Field::real("radius", Dimension::LENGTH).default(1.0).keyword("RADIUS").doc("radius"),
                Field::integer("segment_count").default(20.0).doc("pieces drawn along the curve"),
                Field::object("ref_radius_by_marker", "marker")
                    .doc("marker through which the outline passes; it sets the radius"),
                Field::choice("close", &["chord", "sector", "no", "yes"])
                    .default_word("no")
                    .doc("whether and how the outline is closed"),
            ],
            rules: &[],
            doc: "an arc around z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
