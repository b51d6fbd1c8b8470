//! Names, types, units and defaults of a marker.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "marker",
    word: "Marker",
    families: &["frame"],
    parents: &["part", "ground", "point_mass"],
    prefix: "MARKER_",
    statement: Some("MARKER"),
    groups: &[
        Group {
            command: "marker create",
            creates: true,
            object: "marker_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::LOCATION.keyword("QP"),
                common::ORIENTATION.keyword("REULER"),
                Field::integer("node_id").many().doc("nodes of a flexible body that carry the marker"),
                Field::true_false("preserve_location").doc("keep the given place although nodes carry the marker"),
                common::ALONG_AXIS_ORIENTATION,
                common::IN_PLANE_ORIENTATION,
                Field::orientation("natural_coordinates_relative_orientation")
                    .doc("turn relative to the natural axes of a curve"),
                Field::text("curve_name").doc("curve the marker rides on"),
                Field::object("reference_marker_name", "marker").doc("marker that carries the curve"),
                Field::real("velocity", Dimension::VELOCITY).doc("start speed along the curve"),
                Field::real("vx", Dimension::VELOCITY).doc("start velocity along x"),
                Field::real("vy", Dimension::VELOCITY).doc("start velocity along y"),
                Field::real("vz", Dimension::VELOCITY).doc("start velocity along z"),
                common::RELATIVE_TO,
                Field::location("offset").doc("shift from the node"),
            ],
            rules: &[
                Rule::AtMostOne(&["node_id", "preserve_location"]),
                Rule::AtMostOne(&[
                    "orientation",
                    "along_axis_orientation",
                    "in_plane_orientation",
                    "natural_coordinates_relative_orientation",
                ]),
            ],
            doc: "a frame fixed in a body",
        },
        attributes::MARKER,
    ],
};
