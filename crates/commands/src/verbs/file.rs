//! `file command read|write`, `file adams_data_set read|merge|write`.

use std::path::PathBuf;

use schema::{Field, Kind, Names, UnitName, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, FILE, OPTIONAL_FILE, Outcome},
};
use crate::{
    Interpreter,
    call::Call,
    interpreter::{Flow, cannot_read},
};

pub const COMMAND_READ: VerbEntry = entry(
    Verb { path: "file command read", fields: &[FILE], rules: &[], doc: "runs the commands of a file" },
    command_read,
);

fn command_read(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(argument) = call.argument("file_name") else { return Err(vec![call.missing(&["file_name"])]) };
    let name = interpreter.text_argument_plain(call, argument)?;
    if name.is_empty() {
        return Err(vec![
            Diagnostic::error("command/missing-value", "`file_name` is empty")
                .at(argument.value_span, "name a file")
                .adams("Invalid input. Enter a quoted string."),
        ]);
    }
    let path = interpreter.host.resolve(&name);
    let bytes = std::fs::read(&path).map_err(|e| vec![cannot_read(&path, &e).at(argument.value_span, "this file")])?;
    if let Some(refusal) = interpreter.host.refuse_commands(&path, &bytes) {
        return Err(vec![refusal.at(argument.value_span, "this file")]);
    }
    let file = interpreter.sources.add_bytes(path.display().to_string(), bytes);
    interpreter.asking.insert(file);
    interpreter.trace.push(call.span);
    let flow = interpreter.run_source(file);
    interpreter.trace.pop();
    Ok(flow)
}

pub const COMMAND_WRITE: VerbEntry = entry(
    Verb {
        path: "file command write",
        fields: &[
            Field::object("entity_name", "any").current().doc("model to write, or anything in it"),
            OPTIONAL_FILE,
            shared::MODEL,
            Field::choice("use_parasolid", &["full", "as_is"]).default_word("as_is").doc("how solids are written"),
        ],
        rules: &[],
        doc: "writes a model as commands",
    },
    command_write,
);

fn command_write(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let entity = interpreter.object_argument(call, "entity_name")?;
    let model = match entity.and_then(|e| interpreter.database.model_of(e)) {
        Some(model) => model,
        None => interpreter.model_argument(call)?,
    };
    let path = path_for(interpreter, call, model, "cmd")?;
    let text = interpreter.write_model(model);
    interpreter.host.write_file(&path, &text).map_err(|e| vec![cannot_write(call, &path, &e)])?;
    Ok(Flow::Next)
}

/// The file that is named, or the model's name; with the usual ending where it has none.
fn path_for(interpreter: &mut Interpreter, call: &Call, model: model::ObjectId, extension: &str) -> Outcome<PathBuf> {
    let name = match call.argument("file_name") {
        Some(argument) => interpreter.text_argument_plain(call, argument)?,
        None => interpreter.database.object(model).name.clone(),
    };
    let mut path = interpreter.host.resolve(&name);
    if path.extension().is_none() {
        path.set_extension(extension);
    }
    Ok(path)
}

fn cannot_write(call: &Call, path: &std::path::Path, error: &std::io::Error) -> Diagnostic {
    Diagnostic::error("file/cannot-write", format!("cannot write `{}`: {error}", path.display()))
        .at(call.argument("file_name").map_or(call.span, |a| a.value_span), "this file")
}

const UNITS: [&str; 5] = ["length", "force", "mass", "time", "angle"];

/// Puts the units of a file in force; returns those that were.
fn file_units(
    interpreter: &mut Interpreter,
    call: &Call,
    usual: schema::UnitSystem,
) -> Outcome<Option<schema::UnitSystem>> {
    let old = *interpreter.database.units();
    let mut units = usual;
    for name in UNITS.iter().filter(|n| call.field(n).is_some()) {
        let Some(unit) = interpreter.word_of(call, name)?.and_then(|w| UnitName::find(&w)) else { continue };
        match *name {
            "length" => units.length = unit,
            "force" => units.force = unit,
            "mass" => units.mass = unit,
            "time" => units.time = unit,
            _ => units.angle = unit,
        }
    }
    if units == old {
        return Ok(None);
    }
    units.consistency_factor = None;
    interpreter.database.set_units(units);
    Ok(Some(old))
}

pub const DATA_SET_WRITE: VerbEntry = entry(
    Verb {
        path: "file adams_data_set write",
        fields: &[
            shared::MODEL,
            OPTIONAL_FILE,
            Field::on_off("write_to_terminal").default_word("off").doc("show the dataset"),
            shared::ANGLE,
            shared::LENGTH,
            shared::FORCE,
            shared::MASS,
            shared::TIME,
        ],
        rules: &[],
        doc: "writes a model as a solver dataset; numbers that are 0 are assigned",
    },
    data_set_write,
);

fn data_set_write(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let model = interpreter.model_argument(call)?;
    let path = path_for(interpreter, call, model, "adm")?;
    let usual = *interpreter.database.units();
    let old = file_units(interpreter, call, usual)?;
    let outcome = interpreter.host.write_data_set(&mut interpreter.database, model, &path);
    if let Some(old) = old {
        interpreter.database.set_units(old);
    }
    outcome?;
    interpreter.names.forget();
    interpreter.database.make_current(model);
    if interpreter.flag_argument(call, "write_to_terminal")? == Some(true) {
        let text = std::fs::read_to_string(&path).map_err(|e| vec![cannot_read(&path, &e)])?;
        interpreter.show(&text.lines().map(str::to_string).collect::<Vec<_>>());
    }
    Ok(Flow::Next)
}

pub const DATA_SET_READ: VerbEntry = entry(
    Verb {
        path: "file adams_data_set read",
        fields: &[
            FILE,
            Field::new("model_name", Kind::Object(Names::New, "model")).doc("name of the new model"),
            shared::LENGTH,
            shared::FORCE,
            shared::MASS,
            shared::TIME,
        ],
        rules: &[],
        doc: "reads a solver dataset as a model",
    },
    data_set_read,
);

/// Reads a dataset as a model of its own. Its units are in force afterwards: those the file tells, else
/// those of the command, else consistent ones, whatever was in force: a file is one model in all sessions.
fn read_data_set(interpreter: &mut Interpreter, call: &Call, model_name: Option<&str>) -> Outcome<model::ObjectId> {
    let Some(argument) = call.argument("file_name") else { return Err(vec![call.missing(&["file_name"])]) };
    let name = interpreter.text_argument_plain(call, argument)?;
    let path = interpreter.host.resolve(&name);
    let bytes = std::fs::read(&path).map_err(|e| vec![cannot_read(&path, &e).at(argument.value_span, "this file")])?;
    file_units(interpreter, call, schema::UnitSystem::si())?;
    data_set(interpreter, path.display().to_string(), bytes, model_name)
}

fn data_set(
    interpreter: &mut Interpreter,
    name: String,
    bytes: Vec<u8>,
    model_name: Option<&str>,
) -> Outcome<model::ObjectId> {
    let file = interpreter.sources.add_bytes(name, bytes);
    let source = (&interpreter.sources, file);
    let registry = interpreter.registry.clone();
    let read = interpreter.host.read_data_set(&mut interpreter.database, &registry, source, model_name);
    interpreter.names.forget();
    let read = read?;
    interpreter.function_places.extend(read.functions);
    interpreter.complain(read.diagnostics);
    Ok(read.model)
}

/// Reads the text of a dataset as if it were the file of that name, and makes its model the current one.
pub(crate) fn data_set_text(interpreter: &mut Interpreter, name: &str, bytes: Vec<u8>) -> Outcome<()> {
    interpreter.database.set_units(schema::UnitSystem::si());
    let model = data_set(interpreter, name.to_string(), bytes, None)?;
    interpreter.database.make_current(model);
    Ok(())
}

fn data_set_read(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let model_name = match call.argument("model_name") {
        Some(argument) => Some(interpreter.text_argument_plain(call, argument)?.trim_start_matches('.').to_string()),
        None => None,
    };
    let model = read_data_set(interpreter, call, model_name.as_deref())?;
    interpreter.database.make_current(model);
    Ok(Flow::Next)
}

pub const DATA_SET_MERGE: VerbEntry = entry(
    Verb {
        path: "file adams_data_set merge",
        fields: &[FILE, shared::MODEL, shared::LENGTH, shared::FORCE, shared::MASS, shared::TIME],
        rules: &[],
        doc: "reads a solver dataset into a model that exists; names that are taken get a number",
    },
    data_set_merge,
);

fn data_set_merge(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let target = interpreter.model_argument(call)?;
    let passing = interpreter.free_name(None, "merged_data_set");
    let units = *interpreter.database.units();
    let source = read_data_set(interpreter, call, Some(&passing))?;
    interpreter.database.set_units(units);
    interpreter.merge_into(source, target, call)?;
    interpreter.database.remove(source);
    interpreter.names.forget();
    interpreter.database.make_current(target);
    Ok(Flow::Next)
}
