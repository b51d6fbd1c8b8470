//! Names, types, units and defaults of the arrow of a force.

use schema::{Class, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "force_graphic",
    word: "Force_Graphic",
    families: &["geometry", "shape"],
    parents: &["part", "ground", "point_mass", "model"],
    prefix: "FORCE_GRAPHIC_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create shape force",
            creates: true,
            object: "force_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("joint_name", "joint").doc("joint whose arrow is drawn"),
                Field::object("force_element_name", "force").doc("force whose arrow is drawn"),
                Field::object("applied_at_marker_name", "marker").required().doc("marker at which the arrow starts"),
                Field::object("jprim_name", "primitive_joint").doc("primitive joint whose arrow is drawn"),
                Field::object("curve_curve_name", "curve_curve").doc("curve on curve constraint whose arrow is drawn"),
                Field::object("point_curve_name", "point_curve").doc("point on curve constraint whose arrow is drawn"),
                Field::true_false("all_force_elements").default_word("true").doc("draw arrows of all forces"),
            ],
            rules: &[Rule::AtMostOne(&["joint_name", "jprim_name", "curve_curve_name", "point_curve_name"])],
            doc: "an arrow that shows a force",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
