//! Scripts in files of the solver, settings of runs, and sets of runs.

use model::Value;
use schema::{Dimension, Field, Kind, Names, Rule, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry, refused,
    shared::{MODEL, Outcome},
};
use crate::{
    Interpreter,
    call::Call,
    interpreter::{Flow, cannot_read},
    lookup,
};

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

const fn skipped(path: &'static str, fields: &'static [Field], doc: &'static str) -> VerbEntry {
    refused(Verb { path, fields, rules: &[], doc })
}

const SCRIPT: Field = Field::object("sim_script_name", "script").current().doc("script");

pub const READ_ACF: VerbEntry = verb(
    "simulation script read_acf",
    &[
        Field::new("sim_script_name", Kind::Object(Names::OldOrNew, "script"))
            .required()
            .doc("script that receives the commands; made if it does not exist"),
        Field::new("file_name", Kind::File).required().doc("file of solver commands"),
    ],
    read_acf,
    "reads solver commands from a file into a script",
);
pub const WRITE_ACF: VerbEntry = verb(
    "simulation script write_acf",
    &[SCRIPT, Field::new("file_name", Kind::File).doc("file; the script's name if not given")],
    write_acf,
    "writes the solver commands of a script to a file",
);

fn read_acf(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (Some(name), Some(file)) = (call.argument("sim_script_name"), call.argument("file_name")) else {
        let missing = if call.argument("file_name").is_none() { "file_name" } else { "sim_script_name" };
        return Err(vec![call.missing(&[missing])]);
    };
    let file_name = interpreter.text_argument_plain(call, file)?;
    let mut path = interpreter.host.resolve(&file_name);
    if path.extension().is_none() {
        path.set_extension("acf");
    }
    let bytes = std::fs::read(&path).map_err(|e| vec![cannot_read(&path, &e).at(file.value_span, "this file")])?;
    let lines = String::from_utf8_lossy(&bytes).lines().map(str::to_string).collect();
    let typed = interpreter.text_argument(call, name)?;
    let id = if let Some(id) = lookup::search_one(&interpreter.database, &typed, "script") {
        id
    } else {
        let Some(class) = interpreter.registry.class("script") else {
            return Err(vec![call.missing(&["sim_script_name"])]);
        };
        let place = lookup::new_name(&interpreter.database, &interpreter.registry, class, &typed, name.value_span)
            .map_err(|e| vec![e])?;
        let id = interpreter
            .database
            .create(class, place.parent, &place.name)
            .map_err(|t| vec![lookup::taken(&interpreter.database, class, &typed, t.0, name.value_span)])?;
        interpreter.names.created(&interpreter.database, id);
        id
    };
    // A script runs one kind of commands.
    interpreter.database.set_value(id, "commands", Value::Texts(Vec::new()));
    interpreter.database.set_value(id, "solver_commands", Value::Texts(lines));
    interpreter.database.make_current(id);
    Ok(Flow::Next)
}

fn write_acf(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let named = interpreter.object_argument(call, "sim_script_name")?;
    let Some(id) = named.or_else(|| interpreter.database.current("script")) else {
        return Err(vec![call.missing(&["sim_script_name"])]);
    };
    interpreter.database.make_current(id);
    let lines = match interpreter.database.value(id, "solver_commands") {
        Some(Value::Texts(lines)) if !lines.is_empty() => lines.clone(),
        Some(Value::Text(line)) => vec![line.clone()],
        _ => simple_run(interpreter, id).ok_or_else(|| {
            let name = interpreter.database.full_name(id);
            vec![
                Diagnostic::error("simulation/no-solver-commands", format!("`{name}` holds no solver commands"))
                    .at(call.span, "it runs commands of Adams View")
                    .help("give the script `solver_commands`"),
            ]
        })?,
    };
    let name = match call.argument("file_name") {
        Some(argument) => interpreter.text_argument_plain(call, argument)?,
        None => interpreter.database.object(id).name.clone(),
    };
    let mut path = interpreter.host.resolve(&name);
    if path.extension().is_none() {
        path.set_extension("acf");
    }
    interpreter.host.write_file(&path, &(lines.join("\n") + "\n")).map_err(|e| {
        vec![
            Diagnostic::error("file/cannot-write", format!("cannot write `{}`: {e}", path.display()))
                .at(call.argument("file_name").map_or(call.span, |a| a.value_span), "this file"),
        ]
    })?;
    Ok(Flow::Next)
}

/// The solver commands of a script that only says how long to run.
fn simple_run(interpreter: &Interpreter, id: model::ObjectId) -> Option<Vec<String>> {
    let database = &interpreter.database;
    if let Some(Value::Texts(lines)) = database.value(id, "commands")
        && !lines.is_empty()
    {
        return None;
    }
    let kind = match database.text(id, "type") {
        Some("dynamic") => "DYNAMICS",
        Some("kinematic") => "KINEMATICS",
        Some("static") => "STATICS",
        _ => "TRANSIENT",
    };
    let end = match database.number(id, "duration") {
        Some(duration) => format!("DURATION={duration}"),
        None => format!("END={}", database.number(id, "end_time").unwrap_or(1.0)),
    };
    let output = match database.number(id, "step_size") {
        Some(step) => format!("DTOUT={step}"),
        None => format!("STEPS={}", database.number(id, "number_of_steps").unwrap_or(10.0)),
    };
    let mut lines = Vec::new();
    if database.flag(id, "initial_static") == Some(true) {
        lines.push("SIMULATE/STATICS".to_string());
    }
    lines.push(format!("SIMULATE/{kind}, {end}, {output}"));
    lines.push("STOP".to_string());
    Some(lines)
}

pub const STATE_MATRIX: VerbEntry = skipped(
    "simulation single_run statematrix",
    &[
        MODEL,
        Field::text("state_matrices_name").doc("name of the matrices"),
        Field::yes_no("original").default_word("yes").doc("use the original algorithm"),
        Field::object("plant_input_name", "plant_input").doc("inputs"),
        Field::object("plant_output_name", "plant_output").doc("outputs"),
        Field::object("plant_state_name", "plant_state").doc("states the matrices are reduced to"),
        Field::object("reference_marker", "marker").doc("marker in which the matrices are given"),
        Field::choice("matrix_format", &["matrix_x", "matlab"]).default_word("matrix_x").doc("form of the file"),
        Field::new("file_name", Kind::File).doc("file"),
    ],
    "writes the matrices of the linearised model",
);
pub const SAVE: VerbEntry = skipped(
    "simulation single_run save",
    &[
        Field::new("analysis_name", Kind::Object(Names::New, "analysis")).required().doc("name of the results"),
        Field::yes_no("auto_increment").default_word("no").doc("put a number behind a name that is taken"),
        Field::text("title").doc("title of the results"),
    ],
    "keeps the results of the last run under a name",
);
pub const SINGLE_RUN_SET: VerbEntry = skipped(
    "simulation single_run set",
    &[
        Field::choice("update", &["none", "end", "output_step", "contact_output_step", "time_step", "iteration"])
            .doc("how often the picture is drawn"),
        Field::choice("monitor", &["none", "output_step", "contact_output_step", "time_step", "iteration"])
            .doc("how often progress is reported"),
        Field::real("time_delay", Dimension::NONE).doc("seconds to wait at each picture"),
        Field::yes_no("alert").doc("say when a run is over"),
        Field::on_off("icon_visibility").doc("draw icons during a run"),
        Field::yes_no("save_analyses").doc("keep the results of every run"),
        Field::text("analysis_prefix").doc("what names of kept results begin with"),
    ],
    "what is shown and kept during interactive runs",
);
pub const SET: VerbEntry = skipped(
    "simulation set",
    &[
        Field::choice("solver_preference", &["internal", "external", "write_files_only"]).doc("where the solver runs"),
        Field::text("file_prefix").doc("what names of files begin with"),
        Field::yes_no("save_files").doc("keep the files of the solver"),
        Field::yes_no("load_analysis").doc("read the results of an external run"),
        Field::text("user_solver_executable").doc("program of an external run"),
        Field::yes_no("remote_compute").doc("run on another machine"),
        Field::text("node_name").doc("name of that machine"),
        Field::text("mdi_directory_remote").doc("where Adams is on that machine"),
        Field::text("directory_remote").doc("working folder on that machine"),
        Field::yes_no("verify_first").doc("verify the model before each run"),
        Field::yes_no("show_all_messages").doc("show every message of the solver"),
        Field::yes_no("hold_solver_license").doc("keep the licence between runs"),
        Field::choice("model_update", &["on", "off", "auto"]).doc("draw the model during a run"),
        Field::choice("choice_for_solver", &["fortran", "cplusplus"]).doc("which solver runs"),
    ],
    "where and how the solver runs",
);

const CHARACTERISTIC: Field = Field::choice(
    "output_characteristic",
    &[
        "minimum",
        "maximum",
        "average",
        "last_value",
        "absolute_minimum",
        "absolute_maximum",
        "rms",
        "standard_deviation",
    ],
)
.default_word("maximum")
.doc("what is taken of the measure over a run");

pub const DESIGN_STUDY: VerbEntry = refused(Verb {
    path: "simulation multi_run design_study",
    fields: &[
        MODEL,
        SCRIPT,
        Field::object("variable_name", "variable").doc("design variable that is varied"),
        Field::texts("objective_names").doc("objectives that are evaluated"),
        Field::object("measure_name", "measure").doc("measure that is evaluated"),
        CHARACTERISTIC,
        Field::integer("number_of_levels").default(5.0).doc("values between the limits of the variable"),
    ],
    rules: &[Rule::AtMostOne(&["objective_names", "measure_name"])],
    doc: "runs a model for several values of a variable",
});
pub const OPTIMIZATION: VerbEntry = refused(Verb {
    path: "simulation multi_run optimization",
    fields: &[
        MODEL,
        SCRIPT,
        Field::objects("variable_names", "variable").doc("design variables that are varied"),
        Field::text("objective_name").doc("objective that is optimised"),
        Field::object("measure_name", "measure").doc("measure that is optimised"),
        CHARACTERISTIC,
        Field::texts("constraint_names").doc("limits that must hold"),
        Field::choice("characteristic", &["minimize", "maximize"]).default_word("minimize").doc("direction"),
    ],
    rules: &[Rule::AtMostOne(&["objective_name", "measure_name"])],
    doc: "looks for the best values of variables",
});
