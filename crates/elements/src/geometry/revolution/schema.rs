//! Names, types, units and defaults of a revolution.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common, geometry::fields};

pub const CLASS: Class = Class {
    id: "revolution",
    word: "Revolution",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "REVOLUTION_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape revolution",
            creates: true,
            object: "revolution_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                fields::REFERENCE_MARKER.required(),
                fields::ANALYTICAL,
                fields::PROFILE_CURVE,
                fields::POINTS_FOR_PROFILE,
                Field::real("angle_extent", Dimension::ANGLE)
                    .doc("angle turned through from x towards y; a full turn if not given"),
                Field::integer("number_of_sides").default(20.0).doc("flat sides drawn around"),
                common::RELATIVE_TO,
            ],
            rules: &[
                Rule::AtMostOne(&["profile_curve", "points_for_profile"]),
                Rule::AtLeastOne(&["profile_curve", "points_for_profile"]),
            ],
            doc: "an outline turned around z of a marker",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
