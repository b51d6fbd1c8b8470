//! Names, types, units and defaults of a group.

use schema::{Class, Field, Group};

use crate::common;

pub const CLASS: Class = Class {
    id: "group",
    word: "Group",
    families: &[],
    parents: &["model"],
    prefix: "GROUP_",
    statement: None,
    groups: &[Group {
        command: "group create",
        creates: true,
        object: "group_name",
        fields: &[
            common::COMMENTS,
            Field::objects("objects_in_group", "any").doc("members"),
            Field::text("type_filter").doc("take only objects of this type"),
            Field::yes_no("expand_groups").default_word("no").doc("take the members of groups in place of the groups"),
            Field::integer("expr_active").doc("number or expression that switches the members on"),
        ],
        rules: &[],
        doc: "objects that belong together",
    }],
};
