//! `file command read|write`, `file adams_data_set read|write`.

use schema::{Field, Kind, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{
    Interpreter,
    call::Call,
    interpreter::{Flow, cannot_read},
};

type Outcome = Result<Flow, Vec<Diagnostic>>;

const FILE: Field = Field::new("file_name", Kind::File).required().doc("file");
const MODEL: Field = Field::object("model_name", "model").current().doc("model");

pub const COMMAND_READ: VerbEntry = entry(
    Verb { path: "file command read", fields: &[FILE], rules: &[], doc: "runs the commands of a file" },
    command_read,
);

fn command_read(interpreter: &mut Interpreter, call: &Call) -> Outcome {
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
        fields: &[FILE, Field::object("entity_name", "any").doc("model to write"), MODEL],
        rules: &[],
        doc: "writes a model as commands",
    },
    command_write,
);

fn command_write(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let Some(argument) = call.argument("file_name") else { return Err(vec![call.missing(&["file_name"])]) };
    let entity = interpreter.object_argument(call, "entity_name")?;
    let model = match entity.and_then(|e| interpreter.database.model_of(e)) {
        Some(model) => model,
        None => interpreter.model_argument(call)?,
    };
    let name = interpreter.text_argument_plain(call, argument)?;
    let mut path = interpreter.host.resolve(&name);
    if path.extension().is_none() {
        path.set_extension("cmd");
    }
    let text = interpreter.write_model(model);
    interpreter.host.write_file(&path, &text).map_err(|e| {
        vec![
            Diagnostic::error("file/cannot-write", format!("cannot write `{}`: {e}", path.display()))
                .at(argument.value_span, "this file"),
        ]
    })?;
    Ok(Flow::Next)
}

pub const DATA_SET_WRITE: VerbEntry = entry(
    Verb {
        path: "file adams_data_set write",
        fields: &[FILE, MODEL, Field::on_off("write_to_terminal").doc("show the data set")],
        rules: &[],
        doc: "writes a model as a solver data set; numbers that are 0 are assigned",
    },
    data_set_write,
);

fn data_set_write(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let Some(argument) = call.argument("file_name") else { return Err(vec![call.missing(&["file_name"])]) };
    let model = interpreter.model_argument(call)?;
    let name = interpreter.text_argument_plain(call, argument)?;
    let mut path = interpreter.host.resolve(&name);
    if path.extension().is_none() {
        path.set_extension("adm");
    }
    interpreter.host.write_data_set(&mut interpreter.database, model, &path)?;
    interpreter.names.forget();
    Ok(Flow::Next)
}

pub const DATA_SET_READ: VerbEntry = entry(
    Verb {
        path: "file adams_data_set read",
        fields: &[FILE, Field::text("model_name").doc("name of the new model")],
        rules: &[],
        doc: "reads a solver data set as a model",
    },
    data_set_read,
);

fn data_set_read(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let Some(argument) = call.argument("file_name") else { return Err(vec![call.missing(&["file_name"])]) };
    let name = interpreter.text_argument_plain(call, argument)?;
    let model_name = interpreter.word_of(call, "model_name")?;
    let path = interpreter.host.resolve(&name);
    let model = interpreter.host.read_data_set(&mut interpreter.database, model_name.as_deref(), &path)?;
    interpreter.names.forget();
    interpreter.database.make_current(model);
    Ok(Flow::Next)
}
