//! Names, types, units and defaults of a shell.

use schema::{Class, Field, Group, Kind};

use crate::{attributes, common, geometry::fields};

pub const CLASS: Class = Class {
    id: "shell",
    word: "Shell",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass"],
    prefix: "SHELL_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape shell",
            creates: true,
            object: "shell_name",
            fields: &[
                common::COMMENTS,
                fields::REFERENCE_MARKER,
                Field::new("file_name", Kind::File).required().doc("file with the points and facets"),
                Field::yes_no("wireframe_only").default_word("no").doc("draw edges only"),
            ],
            rules: &[],
            doc: "facets from a file",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
