//! Names, types, units and defaults of an ellipse.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "ellipse",
    word: "Ellipse",
    families: &["geometry", "curve", "wire"],
    parents: &["part", "ground", "point_mass"],
    prefix: "ELLIPSE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve ellipse",
            creates: true,
            object: "ellipse_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("center_marker", "marker").required().doc("marker at the centre, z is the axis"),
                Field::real("major_radius", Dimension::LENGTH).default(1.0).doc("half axis along x"),
                Field::real("minor_radius", Dimension::LENGTH).default(1.0).doc("half axis along y"),
                Field::real("start_angle", Dimension::ANGLE)
                    .default(0.0)
                    .doc("where the line begins, from x towards y"),
                Field::real("end_angle", Dimension::ANGLE).doc("where the line ends; a full turn if not given"),
            ],
            rules: &[],
            doc: "an ellipse, or a part of one, around z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
