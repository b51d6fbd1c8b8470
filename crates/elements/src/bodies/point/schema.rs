//! Names, types, units and defaults of a design point.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "point",
    word: "Point",
    families: &["frame"],
    parents: &["part", "ground", "point_mass"],
    prefix: "POINT_",
    statement: None,
    groups: &[
        Group {
            command: "point create",
            creates: true,
            object: "point_name",
            fields: &[common::COMMENTS, Field::location("location").doc("position of the origin"), common::RELATIVE_TO],
            rules: &[],
            doc: "a place that other objects refer to",
        },
        attributes::POINT,
    ],
};
