//! Names, types, units and defaults of a model.

use schema::{Class, Field, Group};

use crate::{attributes, common};

pub const CLASS: Class = Class {
    id: "model",
    word: "Model",
    families: &["frame"],
    parents: &[],
    prefix: "MODEL_",
    statement: None,
    groups: &[
        Group {
            command: "model create",
            creates: true,
            object: "model_name",
            fields: &[
                common::COMMENTS,
                Field::text("title").doc("line of text shown with the model"),
                Field::texts("view_name").doc("views that show the object"),
                Field::yes_no("fit_to_view")
                    .default_word("yes")
                    .on_create()
                    .doc("zoom so that the model fills the view"),
            ],
            rules: &[],
            doc: "a model, with its ground part",
        },
        attributes::MODEL,
    ],
};
