//! Names, types, units and defaults of a floating marker.

use schema::{Class, Field, Group};

use crate::common;

pub const CLASS: Class = Class {
    id: "floating_marker",
    word: "Floating_Marker",
    families: &[],
    parents: &["part", "ground", "point_mass"],
    prefix: "FMARKER_",
    statement: Some("MARKER"),
    groups: &[Group {
        command: "floating_marker create",
        creates: true,
        object: "floating_marker_name",
        fields: &[
            common::ADAMS_ID,
            common::COMMENTS,
            Field::integer("node_id").many().doc("nodes of a flexible body that carry the marker"),
        ],
        rules: &[],
        doc: "a marker that an element moves during the run",
    }],
};
