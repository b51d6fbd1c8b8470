//! Names, types, units and defaults of a matrix from a file.

use schema::{Class, Field, Group};

use crate::{attributes, common, data::fields};

pub const CLASS: Class = Class {
    id: "matrix_file",
    word: "Matrix",
    families: &["matrix", "data_element"],
    parents: &["model"],
    prefix: "MATRIX_",
    statement: Some("MATRIX"),
    groups: &[
        Group {
            command: "data_element create matrix file",
            creates: true,
            object: "matrix_name",
            fields: &[
                common::ADAMS_ID,
                common::COMMENTS,
                Field::text("file_name").required().keyword("FILE").doc("file that holds the matrix"),
                Field::text("name_of_matrix_in_file").required().keyword("NAME").doc("what the matrix is called there"),
                fields::UNITS,
            ],
            rules: &[],
            doc: "a matrix that the solver reads from a file",
        },
        attributes::DATA_ELEMENT,
    ],
};
