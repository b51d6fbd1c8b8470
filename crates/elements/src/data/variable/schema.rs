//! Names, types, units and defaults of a design variable.

use schema::{Class, Count, Dimension, Field, Group, Rule};

use crate::common;

pub const CLASS: Class = Class {
    id: "variable",
    word: "Variable",
    families: &[],
    parents: &["model", "part", "ground", "point_mass"],
    prefix: "DV_",
    statement: None,
    groups: &[Group {
        command: "variable create",
        creates: true,
        object: "variable_name",
        fields: &[
            common::COMMENTS,
            Field::objects("object_value", "any").doc("objects"),
            Field::integer("integer_value").many().doc("integer values"),
            Field::texts("string_value").doc("texts"),
            Field::text("units").doc("kind of quantity of the value"),
            Field::real("range", Dimension::NONE)
                .quantity_in("units")
                .count(Count::exactly(2))
                .doc("lower and upper limit"),
            Field::yes_no("use_range").doc("the range is enforced"),
            Field::real("allowed_values", Dimension::NONE).quantity_in("units").many().doc("values to choose from"),
            Field::yes_no("use_allowed_values").doc("only allowed values are taken"),
            Field::choice("delta_type", &["absolute", "relative", "percent_relative"])
                .default_word("absolute")
                .doc("how the range counts from the value"),
            Field::real("real_value", Dimension::NONE).quantity_in("units").many().doc("real values"),
            Field::integer("index").doc("place in the list, from 1, that is set"),
        ],
        rules: &[Rule::AtMostOne(&["real_value", "integer_value", "string_value", "object_value"])],
        doc: "a value that expressions refer to",
    }],
};
