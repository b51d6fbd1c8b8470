//! Names, types, units and defaults of a curve that is data.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "curve_element",
    word: "Curve",
    families: &["data_element"],
    parents: &["model"],
    prefix: "CURVE_",
    statement: Some("CURVE"),
    groups: &[
        Group {
            command: "data_element create curve",
            creates: true,
            object: "curve_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::yes_no("closed").default_word("no").keyword("CLOSED").doc("whether it ends where it begins"),
                Field::real("tension", Dimension::NONE).doc("how tightly the curve is drawn through its points"),
                Field::object("matrix_name", "matrix").keyword("MATRIX").doc("matrix whose rows are its points"),
                Field::choice("fit_type", &["control_points", "curve_points"])
                    .default_word("curve_points")
                    .doc("whether the points are on the curve or pull it"),
                Field::integer("interpolation_order").doc("order of the pieces"),
                Field::integer("segment_count").doc("pieces drawn along the curve"),
                fields::USER_FUNCTION,
                Field::real("minimum_parameter", Dimension::NONE).keyword("MINPAR").doc("parameter at the start"),
                Field::real("maximum_parameter", Dimension::NONE).keyword("MAXPAR").doc("parameter at the end"),
                fields::ROUTINE,
            ],
            rules: &[Rule::AtMostOne(&["matrix_name", "user_function"])],
            doc: "a curve in space through the points of a matrix or from a subroutine",
        },
        attributes::DATA_ELEMENT,
    ],
};
