//! Names, types, units and defaults of a curve on a curve.

use schema::{Class, Count, Dimension, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "curve_curve",
    word: "Curve_Curve",
    families: &["constraint", "higher_pair_contact"],
    parents: &["model"],
    prefix: "CVCV_",
    statement: Some("CVCV"),
    groups: &[
        Group {
            command: "constraint create higher_pair_contact curve_curve",
            creates: true,
            object: "curve_curve_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("i_curve_name", common::CURVE)
                    .keyword("ICURVE")
                    .required()
                    .doc("curve on the first body"),
                Field::object("j_curve_name", common::CURVE)
                    .keyword("JCURVE")
                    .required()
                    .doc("curve on the second body"),
                Field::object("i_ref_marker_name", "marker").keyword("IRM").doc("marker that carries the first curve"),
                Field::object("j_ref_marker_name", "marker").keyword("JRM").doc("marker that carries the second curve"),
                Field::object("i_floating_marker_name", "floating_marker")
                    .keyword("IFLOAT")
                    .doc("floating marker of the first body at the point of contact"),
                Field::object("j_floating_marker_name", "floating_marker")
                    .keyword("JFLOAT")
                    .doc("floating marker of the second body at the point of contact"),
                Field::integer("i_marker_id")
                    .on_create()
                    .doc("number of the floating marker that is made on the first body"),
                Field::integer("j_marker_id")
                    .on_create()
                    .doc("number of the floating marker that is made on the second body"),
                Field::real("i_displacement_ic", Dimension::LENGTH)
                    .count(Count::exactly(3))
                    .doc("place on the first curve near which contact starts"),
                Field::true_false("no_i_displacement_ic").doc("forget the place on the first curve"),
                Field::real("j_displacement_ic", Dimension::LENGTH)
                    .count(Count::exactly(3))
                    .doc("place on the second curve near which contact starts"),
                Field::true_false("no_j_displacement_ic").doc("forget the place on the second curve"),
                Field::real("i_velocity_ic", Dimension::VELOCITY).doc("start speed along the first curve"),
                Field::true_false("no_i_velocity_ic").doc("forget the start speed along the first curve"),
                Field::real("j_velocity_ic", Dimension::VELOCITY).doc("start speed along the second curve"),
                Field::true_false("no_j_velocity_ic").doc("forget the start speed along the second curve"),
                Field::object("i_ic_ref_marker_name", "marker")
                    .doc("marker in whose axes the place on the first curve is given"),
                Field::object("j_ic_ref_marker_name", "marker")
                    .doc("marker in whose axes the place on the second curve is given"),
            ],
            rules: &[],
            doc: "keeps two curves in touch",
        },
        attributes::CONSTRAINT,
    ],
};
