//! `macro create|modify|read|write`: commands of the user's own.

use schema::{Field, Kind, Names, Verb};
use text::{Diagnostic, Span};

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup, macros::CLASS};

type Outcome = Result<Flow, Vec<Diagnostic>>;

const NAME: Field = Field::new("macro_name", Kind::Object(Names::OldOrNew, "macro")).required().doc("macro");
const COMMAND: Field = Field::text("user_entered_command").doc("words that call the macro");
const WRAP: Field = Field::yes_no("wrap_in_undo").doc("a call is one step of undo");
const HELP_FILE: Field = Field::text("help_file").doc("file with help on the macro");
const HELP: Field = Field::text("help_string").doc("text of help on the macro");
const PANEL: Field = Field::yes_no("create_panel").doc("make a dialog box");
const CODE: Field = Field::text("security_code").doc("code that hides the lines; Flexure hides nothing");
const OLD: Field = Field::object("macro_name", "macro").current().doc("macro");

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
            CODE,
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
    doubt_lines(interpreter, id, call);
    Ok(Flow::Next)
}

/// Says what is not understood in the parameters of lines that were just given.
fn doubt_lines(interpreter: &mut Interpreter, id: model::ObjectId, call: &Call) {
    let Some(argument) = call.argument("commands_to_be_executed") else { return };
    interpreter.doubt_parameters(id, &|stored, at, length| {
        let line = argument.values.get(stored[..at].matches('\n').count());
        let found = line.and_then(|item| {
            // Escapes may have moved what is looked for; then the whole line is shown.
            let start = call.program.word(item.span).find(stored.get(at..at + length)?)?;
            let from = item.span.start as usize + start;
            Some(Span::new(item.span.file, from, from + length))
        });
        found.or(line.map(|item| item.span)).unwrap_or(argument.value_span)
    });
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

pub const MODIFY: VerbEntry = entry(
    Verb {
        path: "macro modify",
        fields: &[
            OLD,
            Field::new("new_macro_name", Kind::Object(Names::New, "macro")).doc("new name"),
            COMMAND,
            Field::texts("commands_to_be_executed").doc("lines of the macro"),
            WRAP,
            HELP_FILE,
            HELP,
            PANEL,
        ],
        rules: &[],
        doc: "changes a macro",
    },
    modify,
);

fn named(interpreter: &mut Interpreter, call: &Call) -> Result<model::ObjectId, Vec<Diagnostic>> {
    let named = interpreter.object_argument(call, "macro_name")?;
    named.or_else(|| interpreter.database.current("macro")).ok_or_else(|| vec![call.missing(&["macro_name"])])
}

fn modify(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let id = named(interpreter, call)?;
    interpreter.set_own(
        id,
        call,
        &[
            "user_entered_command",
            "commands_to_be_executed",
            "wrap_in_undo",
            "help_file",
            "help_string",
            "create_panel",
        ],
    )?;
    interpreter.register_macro(id);
    doubt_lines(interpreter, id, call);
    interpreter.database.make_current(id);
    if let Some(argument) = call.argument("new_macro_name") {
        let typed = interpreter.text_argument(call, argument)?;
        interpreter.rename(id, &typed, argument.value_span)?;
    }
    Ok(Flow::Next)
}

pub const WRITE: VerbEntry = entry(
    Verb {
        path: "macro write",
        fields: &[OLD, Field::new("file_name", Kind::File).doc("file; the macro's name if not given")],
        rules: &[],
        doc: "writes a macro to a file that `macro read` takes",
    },
    write,
);

fn write(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let id = named(interpreter, call)?;
    let name = match call.argument("file_name") {
        Some(argument) => interpreter.text_argument_plain(call, argument)?,
        None => format!("{}.mac", interpreter.database.object(id).name),
    };
    let path = interpreter.host.resolve(&name);
    let text = text_of(interpreter, id);
    interpreter.host.write_file(&path, &text).map_err(|e| {
        vec![
            Diagnostic::error("file/cannot-write", format!("cannot write `{}`: {e}", path.display()))
                .at(call.argument("file_name").map_or(call.span, |a| a.value_span), "this file"),
        ]
    })?;
    Ok(Flow::Next)
}

/// The lines of a macro under headers for the rest of what it is.
fn text_of(interpreter: &Interpreter, id: model::ObjectId) -> String {
    let database = &interpreter.database;
    let lines = match database.value(id, "commands_to_be_executed") {
        Some(model::Value::Texts(lines)) => lines.clone(),
        Some(model::Value::Text(line)) => vec![line.clone()],
        _ => Vec::new(),
    };
    let yes_no = |name: &str, default: bool| if database.flag(id, name).unwrap_or(default) { "yes" } else { "no" };
    let headers = [
        ("USER_ENTERED_COMMAND", database.text(id, "user_entered_command").unwrap_or_default()),
        ("WRAP_IN_UNDO", yes_no("wrap_in_undo", true)),
        ("HELP_STRING", database.text(id, "help_string").unwrap_or_default()),
        ("CREATE_PANEL", yes_no("create_panel", false)),
    ];
    let mut text = String::new();
    for (key, value) in headers.iter().filter(|(_, value)| !value.is_empty()) {
        text.push_str(&["!", key, " ", value, "\n"].concat());
    }
    // A macro that was read from a file holds the headers of that file; those above say what holds now.
    let is_header = |line: &str| {
        let word = line.trim().strip_prefix('!').and_then(|h| h.split_whitespace().next());
        word.is_some_and(|w| headers.iter().any(|(key, _)| w.eq_ignore_ascii_case(key)))
    };
    for line in lines.iter().filter(|l| !is_header(l)) {
        text.push_str(line);
        text.push('\n');
    }
    text
}
