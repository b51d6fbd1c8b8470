//! Commands on files and results that Flexure does not have: their parameters are checked, and what
//! their absence means is said once in a run.

use schema::{Dimension, Field, Kind, Names, Rule, Verb};

use super::{
    VerbEntry, entry, refused,
    shared::{self, FILE, LENGTH, MASS, Outcome, TIME},
};
use crate::{Interpreter, call::Call, interpreter::Flow};

const FORCE: Field = shared::FORCE;

const fn verb(path: &'static str, fields: &'static [Field], rules: &'static [Rule], doc: &'static str) -> VerbEntry {
    refused(Verb { path, fields, rules, doc })
}

const fn any_name(name: &'static str, class: &'static str, doc: &'static str) -> Field {
    Field::new(name, Kind::Object(Names::OldOrNew, class)).doc(doc)
}

const FILES: Field = Field::new("file_name", Kind::File).many().required().doc("files");
const IN_MODEL: Field = any_name("model_name", "model", "model that the results belong to");
const IN_ANALYSIS: Field = any_name("analysis_name", "analysis", "run that the results belong to");
const ON_DISK: Field = Field::yes_no("disk_based_results").doc("leave the numbers on the disk");
const ONE: &[Rule] = &[Rule::AtMostOne(&["model_name", "analysis_name"])];

pub const ANALYSIS_READ: VerbEntry = verb(
    "file analysis read",
    &[FILES, IN_MODEL, IN_ANALYSIS, LENGTH, FORCE, MASS, TIME],
    ONE,
    "reads the result files of a run",
);
pub const ANALYSIS_WRITE: VerbEntry = verb(
    "file analysis write",
    &[any_name("analysis_name", "analysis", "run to write"), Field::text("file_name").doc("name of the files")],
    &[],
    "writes the result files of a run",
);
pub const REQUEST_READ: VerbEntry = verb(
    "file request read",
    &[
        FILES,
        IN_MODEL,
        IN_ANALYSIS,
        ON_DISK,
        Field::integer("request_ids").many().doc("numbers of the requests to read"),
        Field::integer("time_step_skip").doc("output steps left out between two that are read"),
        LENGTH,
        FORCE,
        MASS,
        TIME,
    ],
    ONE,
    "reads a request file",
);
pub const RESULTS_READ: VerbEntry = verb(
    "file results read",
    &[
        FILES,
        IN_MODEL,
        IN_ANALYSIS,
        ON_DISK,
        Field::integer("skip_time_interval").doc("output steps left out between two that are read"),
        Field::integer("skip_contact_interval").doc("contact steps left out between two that are read"),
        LENGTH,
        FORCE,
        MASS,
        TIME,
    ],
    ONE,
    "reads a results file",
);
pub const GRAPHICS_READ: VerbEntry = verb(
    "file graphics read",
    &[FILES, IN_MODEL, IN_ANALYSIS, ON_DISK, LENGTH, FORCE, MASS, TIME],
    ONE,
    "reads a graphics file",
);
pub const BINARY_READ: VerbEntry = verb(
    "file binary read",
    &[
        Field::new("file_name", Kind::File).doc("file"),
        Field::texts("entity_name").doc("objects to read"),
        Field::choice("mode", &["replace", "error"]).default_word("error").doc("what happens to names that exist"),
        Field::yes_no("alert").default_word("yes").doc("ask first"),
    ],
    &[],
    "reads a binary database of Adams",
);
pub const BINARY_WRITE: VerbEntry = verb(
    "file binary write",
    &[
        Field::new("file_name", Kind::File).doc("file"),
        Field::objects("entity_name", "any").doc("objects to write"),
        Field::texts("exclude_types").doc("types left out"),
        Field::yes_no("compress").default_word("no").doc("write a smaller file"),
        Field::real("demo_version", Dimension::NONE).doc("version of the demonstration"),
        Field::yes_no("alert_if_exists").default_word("yes").doc("ask before a file is replaced"),
    ],
    &[],
    "writes a binary database of Adams",
);
pub const LOG_FILE: VerbEntry = verb(
    "file log_file",
    &[
        Field::new("file_name", Kind::File).doc("file"),
        Field::on_off("write_switch").doc("write the log"),
        Field::on_off("messages_include").doc("write messages to it"),
        Field::on_off("commands_include").doc("write commands to it"),
        Field::on_off("expand_commands").doc("write commands without abbreviations"),
    ],
    &[],
    "where the log goes and what it holds",
);
pub const PARASOLID_READ: VerbEntry = VerbEntry {
    refused: true,
    ..entry(
        Verb {
            path: "file parasolid read",
            fields: &[
                FILE,
                Field::choice("ref_markers", &["local", "global"]).default_word("global").doc("frame of the solids"),
                Field::choice("type", &["ascii", "binary", "neutral"]).doc("kind of file"),
                Field::yes_no("clean_on_import").default_word("yes").doc("repair the solids"),
                Field::yes_no("ignore_density").doc("leave densities out"),
                Field::yes_no("explode_assemblies").default_word("no").doc("one part for each solid of an assembly"),
                any_name("model_name", "model", "model that receives the solids"),
                Field::yes_no("assembly_retain").default_word("no").doc("keep assemblies"),
                any_name("part_name", "body", "part that receives the solids"),
                Field::location("location").doc("where the solids go"),
                Field::orientation("orientation").doc("how they are turned"),
                Field::object("relative_to", "frame")
                    .or_default_coordinate_system()
                    .doc("frame in which that is given"),
                any_name("fe_part_name", "fe_part", "flexible part that receives the solids"),
            ],
            rules: &[
                Rule::AtMostOne(&["model_name", "assembly_retain"]),
                Rule::AtMostOne(&["part_name", "fe_part_name"]),
                Rule::AtMostOne(&["model_name", "part_name"]),
            ],
            doc: "reads solids of other programs",
        },
        parasolid_read,
    )
};
pub const PARASOLID_WRITE: VerbEntry = verb(
    "file parasolid write",
    &[
        FILE,
        Field::choice("type", &["ascii", "binary", "neutral"]).doc("kind of file"),
        Field::object("model_name", "model").doc("model to write"),
        Field::object("analysis_name", "analysis").doc("run whose state is written"),
        Field::integer("frame_number").doc("output step of the run"),
        Field::object("part_name", "body").doc("part to write"),
        Field::yes_no("active_only").default_word("no").doc("leave inactive shapes out"),
    ],
    &[Rule::AtMostOne(&["model_name", "part_name"])],
    "writes solids for other programs",
);

#[allow(clippy::unnecessary_wraps)] // the signature of all verbs
fn parasolid_read(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    // The names of the solids stand in their file only: commands on them are excused later.
    let owner = match call.argument("model_name").or_else(|| call.argument("part_name")) {
        Some(argument) => Some(call.program.word(argument.value_span).to_ascii_lowercase()),
        None => interpreter.database.current("model").map(|m| interpreter.database.full_name(m).to_ascii_lowercase()),
    };
    let full = owner.map(|name| {
        let found = crate::lookup::search_one(&interpreter.database, &name, "any");
        found.map_or(name, |id| interpreter.database.full_name(id).to_ascii_lowercase())
    });
    interpreter.unmade_solids.extend(full);
    for _ in call.all() {}
    interpreter.not_supported(&call.path, call.span);
    Ok(Flow::Skipped)
}

const COMPONENTS: Field = Field::texts("result_set_component_name").required().doc("results");
const NEW_COMPONENT: Field = Field::texts("new_result_set_component_name").required().doc("results that are made");

pub const RESULTS_WRITE: VerbEntry = verb(
    "numeric_results write",
    &[
        COMPONENTS,
        Field::choice("sort_by", &["by_time", "by_value"]).doc("order of the lines"),
        Field::choice("order", &["ascending", "descending"]).default_word("ascending").doc("direction of the order"),
        shared::SHOW,
        Field::new("file_name", Kind::File).doc("file"),
        Field::real("above_value", Dimension::NONE).doc("leave smaller values out"),
        Field::real("below_value", Dimension::NONE).doc("leave larger values out"),
    ],
    &[],
    "writes numbers of a run",
);
pub const RESULTS_READ_FROM_FILE: VerbEntry = verb(
    "numeric_results read_from_file",
    &[
        NEW_COMPONENT,
        Field::integer("number_of_steps").doc("number of values"),
        Field::text("units").doc("kind of quantity"),
        FILE,
    ],
    &[],
    "reads numbers as results",
);
pub const RESULTS_CREATE: VerbEntry = verb(
    "numeric_results create values",
    &[
        NEW_COMPONENT,
        Field::real("values", Dimension::NONE).many().required().doc("values"),
        Field::text("units").default_word("no_units").doc("kind of quantity"),
    ],
    &[],
    "makes results of given numbers",
);
pub const RESULTS_DELETE: VerbEntry = verb(
    "numeric_results delete",
    &[Field::texts("result_set_name").required().doc("sets of results to delete")],
    &[],
    "deletes sets of results",
);
