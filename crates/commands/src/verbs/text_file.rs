//! `file text ...`: text files that programs of commands write, line by line in printf formats.

use std::{
    fs::{File, OpenOptions},
    io::Write,
    path::PathBuf,
};

use model::Value;
use schema::{Field, Kind, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, shared::Outcome};
use crate::{Interpreter, call::Call, interpreter::Flow, values::text_of};

/// A file that is open.
#[derive(Debug)]
pub struct TextFile {
    /// As named when it was opened.
    name: String,
    path: PathBuf,
    /// None where it was opened to be read.
    file: Option<Out>,
}

/// Where what is written goes.
#[derive(Debug)]
enum Out {
    File(File),
    /// The session only checks what it reads.
    Nowhere,
}

const NAME: Field = Field::new("file_name", Kind::File).doc("file");

pub const OPEN: VerbEntry = entry(
    Verb {
        path: "file text open",
        fields: &[
            NAME.required(),
            Field::choice("open_mode", &["overwrite", "append", "read"])
                .required()
                .doc("whether what the file holds is replaced, continued or read"),
        ],
        rules: &[],
        doc: "opens a text file",
    },
    open,
);
pub const WRITE: VerbEntry = entry(
    Verb {
        path: "file text write",
        fields: &[
            NAME,
            Field::object("variable_name", "variable").doc("variable that receives the text in place of a file"),
            Field::text("format_for_output").required().doc("printf format"),
            Field::new("values_for_output", Kind::Any).many().doc("values for the format"),
            Field::yes_no("newline").default_word("yes").doc("end the line"),
        ],
        rules: &[],
        doc: "writes values in a format to an open file, a variable, or the information window",
    },
    write,
);
pub const CLOSE: VerbEntry =
    entry(Verb { path: "file text close", fields: &[NAME], rules: &[], doc: "closes a text file, or all" }, close);

fn name_of(interpreter: &mut Interpreter, call: &Call) -> Outcome<Option<(String, PathBuf)>> {
    let Some(argument) = call.argument("file_name") else { return Ok(None) };
    let name = interpreter.text_argument_plain(call, argument)?;
    let path = interpreter.host.resolve(&name);
    Ok(Some((name, path)))
}

fn open(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some((name, path)) = name_of(interpreter, call)? else { return Err(vec![call.missing(&["file_name"])]) };
    let Some(mode) = interpreter.word_of(call, "open_mode")? else { return Err(vec![call.missing(&["open_mode"])]) };
    if mode != "read" && !interpreter.host.may_write() {
        interpreter.text_files.retain(|f| f.path != path);
        interpreter.text_files.push(TextFile { name, path, file: Some(Out::Nowhere) });
        return Ok(Flow::Next);
    }
    let mut options = OpenOptions::new();
    match mode.as_str() {
        "append" => options.append(true).create(true),
        "read" => options.read(true),
        _ => options.write(true).create(true).truncate(true),
    };
    let file = options.open(&path).map_err(|e| {
        let verb = if mode == "read" { "read" } else { "write" };
        let code = if mode == "read" { "file/cannot-read" } else { "file/cannot-write" };
        vec![
            Diagnostic::error(code, format!("cannot {verb} `{}`: {e}", path.display()))
                .at(call.argument("file_name").map_or(call.span, |a| a.value_span), "this file")
                .adams(format!("Unable to open file named '{name}'.")),
        ]
    })?;
    interpreter.text_files.retain(|f| f.path != path);
    interpreter.text_files.push(TextFile { name, path, file: (mode != "read").then_some(Out::File(file)) });
    Ok(Flow::Next)
}

fn write(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(format) = interpreter.word_of(call, "format_for_output")? else {
        return Err(vec![call.missing(&["format_for_output"])]);
    };
    let values = values(interpreter, call)?;
    let span = call.argument("format_for_output").map_or(call.span, |a| a.value_span);
    let mut text = expressions::sprintf(&escapes(&format), &values).map_err(|why| {
        vec![
            Diagnostic::error("file/format", format!("the format \"{format}\" does not fit its values: {why}"))
                .at(span, "cannot be filled")
                .help("each % takes one value: %d whole numbers, %f, %e and %g reals, %s texts"),
        ]
    })?;
    let newline = interpreter.flag_argument(call, "newline")? != Some(false);
    if let Some(variable) = interpreter.object_argument(call, "variable_name")? {
        interpreter.set_variable_text(variable, &text, call)?;
        return Ok(Flow::Next);
    }
    if newline {
        text.push('\n');
    }
    let named = name_of(interpreter, call)?;
    let file = match &named {
        Some((_, path)) => interpreter.text_files.iter_mut().find(|f| f.path == *path),
        None => interpreter.text_files.last_mut(),
    };
    let name = match (&file, &named) {
        (Some(file), _) => file.name.clone(),
        (None, Some((name, _))) => name.clone(),
        (None, None) => {
            interpreter.show(&text.lines().map(str::to_string).collect::<Vec<_>>());
            return Ok(Flow::Next);
        }
    };
    let Some(out) = file.and_then(|f| f.file.as_mut()) else {
        return Err(vec![
            Diagnostic::error("file/not-open", format!("`{name}` is not open for writing"))
                .at(call.span, "nothing is written")
                .help(format!("file text open file_name = \"{name}\" open_mode = append")),
        ]);
    };
    let Out::File(out) = out else { return Ok(Flow::Next) };
    out.write_all(text.as_bytes()).map_err(|e| {
        vec![Diagnostic::error("file/cannot-write", format!("cannot write `{name}`: {e}")).at(call.span, "this file")]
    })?;
    Ok(Flow::Next)
}

/// Every value as text; numbers in the shortest form that reads back.
fn values(interpreter: &mut Interpreter, call: &Call) -> Outcome<Vec<String>> {
    let Some(argument) = call.argument("values_for_output") else { return Ok(Vec::new()) };
    let mut texts = Vec::new();
    for item in &argument.values {
        let one = syntax::command::Argument { values: [item.clone()].into_iter().collect(), ..argument.clone() };
        let field = Field::new("values_for_output", Kind::Any);
        match interpreter.read_value(call, &field, &one, None)?.value {
            Value::Array(array) => texts.extend(array.values.iter().map(|x| format!("{x:?}"))),
            Value::Texts(list) => texts.extend(list),
            Value::Objects(ids) => texts.extend(ids.iter().map(|id| interpreter.database.full_name(*id))),
            other => texts.push(text_of(&other, &interpreter.database)),
        }
    }
    Ok(texts)
}

/// `\n` and `\t` of a format.
fn escapes(format: &str) -> String {
    format.replace("\\n", "\n").replace("\\t", "\t")
}

fn close(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some((name, path)) = name_of(interpreter, call)? else {
        interpreter.text_files.clear();
        return Ok(Flow::Next);
    };
    let before = interpreter.text_files.len();
    interpreter.text_files.retain(|f| f.path != path);
    if interpreter.text_files.len() == before {
        return Err(vec![
            Diagnostic::error("file/not-open", format!("`{name}` is not open")).at(call.span, "nothing to close"),
        ]);
    }
    Ok(Flow::Next)
}
