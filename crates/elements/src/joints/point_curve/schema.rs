//! Names, types, units and defaults of a point on a curve.

use schema::{Class, Count, Dimension, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "point_curve",
    word: "Point_Curve",
    families: &["constraint", "higher_pair_contact"],
    parents: &["model"],
    prefix: "PTCV_",
    statement: Some("PTCV"),
    groups: &[
        Group {
            command: "constraint create higher_pair_contact point_curve",
            creates: true,
            object: "point_curve_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                common::I_MARKER,
                Field::object("j_floating_marker_name", "floating_marker")
                    .keyword("JFLOAT")
                    .doc("floating marker of the curve's body that follows the point"),
                Field::integer("j_marker_id").on_create().doc("number of the floating marker that is made"),
                Field::object("ref_marker_name", "marker").keyword("RM").doc("marker that carries the curve"),
                Field::object("curve_name", common::CURVE).required().keyword("CURVE").doc("curve the point stays on"),
                Field::real("displacement_ic", Dimension::LENGTH)
                    .count(Count::exactly(3))
                    .doc("place on the curve near which the point starts"),
                Field::true_false("no_displacement_ic").doc("forget the place at the start"),
                Field::real("velocity_ic", Dimension::VELOCITY).doc("start speed along the curve"),
                Field::true_false("no_velocity_ic").doc("forget the start speed"),
                Field::object("ic_ref_marker_name", "marker")
                    .doc("marker in whose axes the place at the start is given"),
                common::I_PART,
                common::LOCATION.on_create(),
                common::RELATIVE_TO.on_create(),
            ],
            rules: &[
                Rule::AtMostOne(&["i_marker_name", "i_part_name"]),
                Rule::AtLeastOne(&["i_marker_name", "i_part_name"]),
                Rule::AtMostOne(&["i_marker_name", "location"]),
                Rule::AtLeastOne(&["i_marker_name", "location"]),
            ],
            doc: "keeps a point of one body on a curve of another",
        },
        attributes::CONSTRAINT,
    ],
};
