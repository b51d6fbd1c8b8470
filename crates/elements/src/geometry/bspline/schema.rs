//! Names, types, units and defaults of a B-spline curve.

use schema::{Class, Field, Group, Rule};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "bspline",
    word: "Bspline",
    families: &["geometry", "curve", "wire"],
    parents: &["part", "ground", "point_mass"],
    prefix: "GCURVE_",
    statement: Some("GRAPHICS"),
    groups: &[
        Group {
            command: "geometry create curve bspline",
            creates: true,
            object: "bspline_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::object("ref_curve_name", "curve_element").doc("data element whose curve is drawn"),
                Field::object("ref_profile_name", "wire").doc("curve whose points are taken over"),
                Field::objects("ref_marker_name", "marker").required().doc("marker in whose axes the curve is given"),
                Field::yes_no("spread_points").doc("lay the points evenly along the curve"),
                Field::yes_no("closed").doc("whether the curve ends where it begins"),
                Field::integer("num_new_pts").doc("number of points the curve is given"),
                Field::integer("segment_count").default(20.0).doc("pieces drawn along the curve"),
            ],
            rules: &[Rule::AtMostOne(&["ref_curve_name", "ref_profile_name"])],
            doc: "a smooth curve that follows a data element or another curve",
        },
        attributes::GEOMETRY,
        attributes::GEOMETRY_MORE,
    ],
};
