//! Names, types, units and defaults of the preferences of the solver.

use schema::{Class, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "preferences",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "PREFERENCES_",
    statement: Some("PREFERENCES"),
    groups: &[Group {
        command: "executive_control set preferences",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::real("contact_faceting_tolerance", Dimension::NONE)
                .doc("how finely shapes are divided where contact needs it"),
            Field::text("contact_geometry_library").doc("library that finds contacts"),
            Field::integer("thread_count").doc("threads the solver may use"),
        ],
        rules: &[],
        doc: "preferences of the solver; one set for each model, made by the first use",
    }],
};
