//! Names, types and defaults of a function of the user's own for expressions.

use schema::{Class, Field, Group};

use crate::common;

pub const CLASS: Class = Class {
    id: "function",
    word: "Function",
    families: &[],
    parents: &["model"],
    prefix: "FUNCTION_",
    statement: None,
    groups: &[Group {
        command: "function create",
        creates: true,
        object: "function_name",
        fields: &[
            Field::texts("text_of_expression").required().doc("expression that gives the value"),
            Field::texts("argument_names").doc("names that stand for the arguments in it"),
            Field::choice("type", &["array", "integer", "location_orientation", "object", "real", "string"])
                .default_word("real")
                .doc("what the function gives"),
            common::COMMENTS,
            Field::choice(
                "category",
                &["user", "string", "math", "modelling", "loc_ori", "matrix_array", "database_object", "misc"],
            )
            .on_create()
            .doc("under which heading it is listed"),
        ],
        rules: &[],
        doc: "a function of the user's own for expressions",
    }],
};
