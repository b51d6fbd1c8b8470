//! Names, types, units and defaults of a simulation script.

use schema::{Class, Dimension, Field, Group};

use crate::common;

pub const CLASS: Class = Class {
    id: "script",
    word: "Script",
    families: &[],
    parents: &["model"],
    prefix: "SIM_SCRIPT_",
    statement: None,
    groups: &[Group {
        command: "simulation script create",
        creates: true,
        object: "sim_script_name",
        fields: &[
            common::COMMENTS,
            Field::texts("solver_commands").doc("solver commands the script runs"),
            Field::texts("commands").doc("commands the script runs"),
            Field::choice("type", &["dynamic", "kinematic", "static", "auto_select"])
                .default_word("auto_select")
                .doc("kind of analysis"),
            Field::yes_no("initial_static").default_word("no").doc("find static equilibrium first"),
            Field::integer("number_of_steps").default(10.0).doc("number of output steps"),
            Field::real("step_size", Dimension::TIME).doc("time between outputs"),
            Field::real("end_time", Dimension::TIME).default(1.0).doc("time at which the run ends"),
            Field::real("duration", Dimension::TIME).doc("how long to run from now"),
        ],
        rules: &[],
        doc: "what a scripted run does",
    }],
};
