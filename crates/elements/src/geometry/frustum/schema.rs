//! Names, types, units and defaults of a frustum.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "frustum",
    word: "Frustum",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "FRUSTUM_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape frustum",
            creates: true,
            object: "frustum_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker")
                    .required()
                    .keyword("CM")
                    .doc("marker at the centre of the base, z is the axis"),
                Field::real("angle_extent", Dimension::ANGLE)
                    .doc("swept angle from x towards y; a full turn if not given"),
                Field::real("length", Dimension::LENGTH)
                    .default(1.0)
                    .keyword("LENGTH")
                    .doc("length along z of the centre marker"),
                Field::real("top_radius", Dimension::LENGTH).default(1.0).keyword("TOP").doc("radius at the far end"),
                Field::real("bottom_radius", Dimension::LENGTH)
                    .default(1.0)
                    .keyword("BOTTOM")
                    .doc("radius at the centre marker"),
                Field::integer("side_count_for_body").default(20.0).keyword("SIDES").doc("flat sides drawn around"),
                Field::integer("segment_count_for_ends")
                    .default(20.0)
                    .keyword("SEG")
                    .doc("pieces the end circles are drawn with"),
            ],
            rules: &[],
            doc: "a cut cone along z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
