//! `help`, `pause`, `abort`, `quit`, `stop`, `exit`, `system`, `library create`: the session itself.

use schema::{Dimension, Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, refused, shared::Outcome};
use crate::{Interpreter, call::Call, interpreter::Flow, tree::Path};

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

pub const HELP: VerbEntry = verb(
    "help",
    &[
        Field::text("command_or_topic").doc("words of a command"),
        Field::on_off("context_sensitive").doc("help on what the pointer is on"),
        Field::choice("tips", &["on", "off", "toggle"]).doc("tips while the pointer rests"),
    ],
    help,
    "says what a command does and what it takes",
);
pub const PAUSE: VerbEntry = refused(Verb {
    path: "pause",
    fields: &[
        Field::real("time_delay", Dimension::NONE).doc("seconds to wait"),
        Field::yes_no("alert").default_word("yes").doc("wait for an answer"),
    ],
    rules: &[],
    doc: "waits; Flexure goes on at once, as nobody is asked",
});
pub const VIEW_ERASE: VerbEntry = verb(
    "view erase",
    &[Field::text("view_name").doc("views to clear")],
    erase,
    "clears views of what is drawn in them; there are none here, so nothing is lost",
);
pub const ABORT: VerbEntry = verb(
    "abort",
    &[Field::yes_no("stop_all_commands").default_word("no").doc("leave all files and macros, not only the innermost")],
    abort,
    "leaves the file or macro that is being run",
);
const CONFIRMATION: Field = Field::yes_no("confirmation").doc("ask first; nobody is asked in Flexure");
pub const QUIT: VerbEntry = verb("quit", &[CONFIRMATION], end, "ends the session");
pub const STOP: VerbEntry = verb("stop", &[CONFIRMATION], end, "ends the session");
pub const EXIT: VerbEntry = verb("exit", &[CONFIRMATION], end, "ends the session");
pub const SYSTEM: VerbEntry = refused(Verb {
    path: "system",
    fields: &[
        Field::text("command_text").required().doc("command of the operating system"),
        Field::on_off("send_output_to_info_window").default_word("on").doc("show what it prints"),
        Field::on_off("echo_to_logfile").default_word("off").doc("write what it prints to the log"),
    ],
    rules: &[],
    doc: "runs another program in Adams; Flexure starts none",
});

fn abort(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let all = interpreter.flag_argument(call, "stop_all_commands")? == Some(true);
    Ok(if all { Flow::Abort } else { Flow::Return })
}

fn end(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    interpreter.flag_argument(call, "confirmation")?;
    interpreter.report.ended = true;
    Ok(Flow::Abort)
}

/// Every model that Adams writes has this line; no view shows anything that it could take away.
#[allow(clippy::unnecessary_wraps)] // the signature of all verbs
fn erase(_: &mut Interpreter, _: &Call) -> Outcome<Flow> {
    Ok(Flow::Next)
}

fn help(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let topic = interpreter.word_of(call, "command_or_topic")?.unwrap_or_default();
    let words: Vec<&str> = topic.split_whitespace().collect();
    let lines = match interpreter.tree.find(&words, &interpreter.database) {
        Path::Found(command) => {
            let mut lines = vec![command.path.to_string()];
            let doc = command.doc();
            if !doc.is_empty() {
                lines.push(format!("   {doc}"));
            }
            lines.extend(command.parameters.iter().map(|p| format!("   {:<28} {}", p.name, p.field.doc)));
            lines
        }
        Path::Incomplete { next } => {
            let mut lines = vec![if topic.is_empty() { "commands".into() } else { format!("{topic} ...") }];
            lines.extend(next.iter().map(|word| format!("   {word}")));
            lines
        }
        _ => {
            let span = call.argument("command_or_topic").map_or(call.span, |a| a.value_span);
            return Err(vec![
                Diagnostic::error("help/no-topic", format!("there is no help on `{topic}`"))
                    .at(span, "no command")
                    .help("give the words of a command, as in help command_or_topic = \"marker create\""),
            ]);
        }
    };
    interpreter.show(&lines);
    Ok(Flow::Next)
}
