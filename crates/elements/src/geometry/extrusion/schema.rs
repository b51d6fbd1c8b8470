//! Names, types, units and defaults of an extrusion.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common, geometry::fields};

pub const CLASS: Class = Class {
    id: "extrusion",
    word: "Extrusion",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "EXTRUSION_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape extrusion",
            creates: true,
            object: "extrusion_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                fields::REFERENCE_MARKER.required(),
                fields::ANALYTICAL,
                fields::PROFILE_CURVE,
                fields::POINTS_FOR_PROFILE,
                Field::objects("path_curve", "wire").doc("curve along which the profile is pushed"),
                fields::points("path_points").doc("points along which the profile is pushed"),
                Field::real("length_along_z_axis", Dimension::LENGTH)
                    .doc("length along z of the reference marker, either way"),
                Field::objects("profiles_loft", "wire").doc("outlines between which a skin is laid"),
                Field::objects("centerline_loft", "wire").doc("middle line that the skin follows"),
                common::RELATIVE_TO,
            ],
            rules: &[
                Rule::AtMostOne(&["profile_curve", "points_for_profile"]),
                Rule::AtMostOne(&[
                    "path_curve",
                    "path_points",
                    "length_along_z_axis",
                    "profiles_loft",
                    "centerline_loft",
                ]),
                Rule::AtLeastOne(&["profile_curve", "points_for_profile", "profiles_loft"]),
                Rule::AtLeastOne(&[
                    "path_curve",
                    "path_points",
                    "length_along_z_axis",
                    "profiles_loft",
                    "centerline_loft",
                ]),
            ],
            doc: "an outline pushed along z of a marker or along a path",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
