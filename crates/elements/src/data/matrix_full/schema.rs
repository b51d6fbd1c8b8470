//! Names, types, units and defaults of a matrix with all its values.

use schema::{Class, Dimension, Field, Group, Rule};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "matrix_full",
    word: "Matrix",
    families: &["matrix", "data_element"],
    parents: &["model"],
    prefix: "MATRIX_",
    statement: Some("MATRIX"),
    groups: &[
        Group {
            command: "data_element create matrix full",
            creates: true,
            object: "matrix_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::choice("input_order", &["by_column", "by_row"])
                    .default_word("by_column")
                    .doc("whether the values run down the columns or along the rows"),
                Field::integer("row_count").keyword("ROWS").doc("number of rows"),
                Field::integer("column_count").keyword("COLUMNS").doc("number of columns"),
                Field::real("values", Dimension::NONE).many().keyword("VALUES").doc("all values in order"),
                Field::objects("result_set_component_names", "data_element")
                    .on_create()
                    .doc("recorded columns that become the columns of the matrix"),
                fields::UNITS,
            ],
            rules: &[
                Rule::AtMostOne(&["values", "result_set_component_names"]),
                Rule::AtLeastOne(&["values", "result_set_component_names"]),
            ],
            doc: "a matrix given by all its values",
        },
        attributes::DATA_ELEMENT,
    ],
};
