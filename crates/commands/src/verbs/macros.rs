//! `macro create` and `macro read`.

use schema::{Field, Kind, Names, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup, macros::CLASS};

type Outcome = Result<Flow, Vec<Diagnostic>>;

const NAME: Field = Field::new("macro_name", Kind::Object(Names::OldOrNew, "macro")).required().doc("macro");
const COMMAND: Field = Field::text("user_entered_command").doc("words that call the macro");
const WRAP: Field = Field::yes_no("wrap_in_undo").doc("a call is one step of undo");
const HELP_FILE: Field = Field::text("help_file").doc("file with help on the macro");
const HELP: Field = Field::text("help_string").doc("text of help on the macro");
const PANEL: Field = Field::yes_no("create_panel").doc("make a dialog box");

pub const CREATE: VerbEntry = entry(
    Verb {
        path: "macro create",
        fields: &[
            NAME,
            COMMAND,
            Field::texts("commands_to_be_executed").required().doc("lines of the macro"),
            WRAP,
            HELP_FILE,
            HELP,
            PANEL,
        ],
        rules: &[],
        doc: "makes a command of other commands",
    },
    create,
);

fn create(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    for name in ["macro_name", "commands_to_be_executed"] {
        if call.argument(name).is_none() {
            return Err(vec![call.missing(&[name])]);
        }
    }
    let Some(argument) = call.argument("macro_name") else { return Ok(Flow::Next) };
    let typed = interpreter.text_argument(call, argument)?;
    let span = argument.value_span;
    let place = lookup::new_name(&interpreter.database, &interpreter.registry, &CLASS, &typed, span)
        .or_else(|e| {
            let bare = !typed.contains('.');
            if bare { Ok(lookup::NewName { parent: None, name: typed.clone() }) } else { Err(e) }
        })
        .map_err(|e| vec![e])?;
    let id = interpreter
        .database
        .create(&CLASS, place.parent, &place.name)
        .map_err(|t| vec![lookup::taken(&interpreter.database, &CLASS, &typed, t.0, span)])?;
    interpreter.set_fields(id, call)?;
    interpreter.register_macro(id);
    Ok(Flow::Next)
}

pub const READ: VerbEntry = entry(
    Verb {
        path: "macro read",
        fields: &[
            NAME,
            Field::new("file_name", Kind::File).required().doc("file"),
            COMMAND,
            WRAP,
            HELP_FILE,
            HELP,
            PANEL,
        ],
        rules: &[],
        doc: "makes a command of the commands in a file",
    },
    read,
);

fn read(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    interpreter.read_macro(call)
}
