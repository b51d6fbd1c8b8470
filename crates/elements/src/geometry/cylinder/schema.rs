//! Names, types, units and defaults of a cylinder.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "cylinder",
    word: "Cylinder",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "CYLINDER_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape cylinder",
            creates: true,
            object: "cylinder_name",
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
                Field::real("radius", Dimension::LENGTH).default(1.0).keyword("RADIUS").doc("radius"),
                Field::integer("side_count_for_body").default(20.0).keyword("SIDES").doc("flat sides drawn around"),
                Field::integer("segment_count_for_ends")
                    .default(20.0)
                    .keyword("SEG")
                    .doc("pieces the end circles are drawn with"),
                Field::object("ref_radius_by_marker", "marker")
                    .doc("marker through which the outline passes; it sets the radius"),
            ],
            rules: &[],
            doc: "a cylinder along z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
