//! Names of an analysis, which owns the results of a run.

use schema::{Class, Group};

pub const CLASS: Class = Class {
    id: "analysis",
    word: "Analysis",
    families: &[],
    parents: &["model"],
    prefix: "ANALYSIS_",
    statement: None,
    groups: &[Group {
        command: "analysis create",
        creates: true,
        object: "analysis_name",
        fields: &[],
        rules: &[],
        doc: "a place for the results of a run",
    }],
};
