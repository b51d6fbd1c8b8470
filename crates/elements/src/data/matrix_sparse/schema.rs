//! Names, types, units and defaults of a sparse matrix.

use schema::{Class, Dimension, Field, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "matrix_sparse",
    word: "Matrix",
    families: &["matrix", "data_element"],
    parents: &["model"],
    prefix: "MATRIX_",
    statement: Some("MATRIX"),
    groups: &[
        Group {
            command: "data_element create matrix sparse",
            creates: true,
            object: "matrix_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::integer("row_index").many().required().doc("row of each value"),
                Field::integer("column_index").many().required().doc("column of each value"),
                Field::real("values", Dimension::NONE).many().required().doc("values that are not zero"),
                fields::UNITS,
            ],
            rules: &[],
            doc: "a matrix given by its values that are not zero",
        },
        attributes::DATA_ELEMENT,
    ],
};
