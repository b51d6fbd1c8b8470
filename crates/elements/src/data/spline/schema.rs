//! Names, types, units and defaults of a spline.

use schema::{Class, Count, Dimension, Field, Group, Rule};

use crate::{attributes, common, data::fields};

const AT_LEAST_FOUR: Count = Count::between(4, usize::MAX);

pub const CLASS: Class = Class {
    id: "spline",
    word: "Spline",
    families: &["data_element"],
    parents: &["model"],
    prefix: "SPLINE_",
    statement: Some("SPLINE"),
    groups: &[
        Group {
            command: "data_element create spline",
            creates: true,
            object: "spline_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::text("file_name").keyword("FILE").doc("file that holds the points"),
                Field::text("block_name").keyword("BLOCK").doc("part of the file that holds them"),
                Field::integer("channel").keyword("CHANNEL").doc("column of the file that holds them"),
                fields::ROUTINE,
                Field::real("x", Dimension::NONE).count(AT_LEAST_FOUR).keyword("X").doc("values on the axis, rising"),
                Field::real("y", Dimension::NONE)
                    .count(AT_LEAST_FOUR)
                    .keyword("Y")
                    .doc("a value for each x, and for each z one set of them"),
                Field::real("z", Dimension::NONE)
                    .count(Count::between(2, usize::MAX))
                    .doc("values on the second axis of a surface"),
                Field::object("x_result_set_component_name", "data_element").doc("recorded column taken for x"),
                Field::objects("y_result_set_component_name", "data_element").doc("recorded columns taken for y"),
                Field::object("z_result_set_component_name", "data_element").doc("recorded column taken for z"),
                Field::yes_no("linear_extrapolate").keyword("LINEAR_EXTRAPOLATE").doc("go on straight beyond the ends"),
                fields::UNITS,
                Field::text("x_units").doc("kind of quantity of x"),
                Field::text("y_units").doc("kind of quantity of y"),
                Field::text("z_units").doc("kind of quantity of z"),
            ],
            rules: &[Rule::AtMostOne(&["file_name", "x"]), Rule::AtMostOne(&["file_name", "y"])],
            doc: "points through which a smooth function goes",
        },
        attributes::DATA_ELEMENT,
    ],
};
