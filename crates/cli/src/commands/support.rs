//! `flexure support`: what is run, what is kept but not simulated, what is not supported; and the
//! table of one command, for people as `help` shows it, for programs and the manual as JSON.

use comfy_table::{Table, presets};
use flexure::{CommandReference, Count, ParameterReference, Role, Rule};
use serde_json::{Value, json};

use crate::Outcome;
use crate::arguments::{DiffFormat, Support};
use crate::commands::{complain, session};

pub(super) fn execute(request: &Support) -> Outcome {
    if request.words.is_empty() {
        list(request.format);
        return Outcome::Fine;
    }
    let words: Vec<&str> = request.words.iter().flat_map(|w| w.split_whitespace()).collect();
    let session = session();
    match (session.reference(&words), request.format) {
        (Some(reference), DiffFormat::Json) => println!("{:#}", command(&reference)),
        (Some(_), DiffFormat::Text) => session.help(&words).iter().for_each(|line| println!("{line}")),
        (None, _) => {
            session.help(&words).iter().for_each(complain);
            return Outcome::Usage;
        }
    }
    Outcome::Fine
}

fn list(format: DiffFormat) {
    let entries = flexure::support();
    if format == DiffFormat::Json {
        let row = |e: flexure::Support| json!({ "command": e.command, "state": e.state.to_string(), "note": e.note });
        println!("{:#}", Value::Array(entries.into_iter().map(row).collect()));
        return;
    }
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    table.set_header(["command", "state", "note"]);
    for entry in entries {
        table.add_row([entry.command, entry.state.to_string(), entry.note]);
    }
    println!("{table}");
}

fn command(reference: &CommandReference) -> Value {
    json!({
        "command": reference.command,
        "doc": reference.doc,
        "parameters": reference.parameters.iter().map(parameter).collect::<Vec<_>>(),
        "rules": reference.rules.iter().map(rule).collect::<Vec<_>>(),
    })
}

fn parameter(p: &ParameterReference) -> Value {
    let Count { least, most } = p.count;
    json!({
        "name": p.name,
        "role": match p.role { Role::Object => "object", Role::NewName => "new_name", Role::Field => "value" },
        "type": p.kind,
        "words": p.words,
        "least": least,
        // Without a limit: null.
        "most": (most != usize::MAX).then_some(most),
        "dimension": p.dimension,
        "unit": p.unit,
        "default": p.default,
        "must_be": p.limit,
        "required": p.required,
        "keyword": p.keyword,
        "shortest": p.shortest,
        "doc": p.doc,
    })
}

fn rule(rule: &Rule) -> Value {
    match rule {
        Rule::OneOf(sets) => json!({ "rule": "one_of", "sets": sets }),
        Rule::AtMostOne(names) => json!({ "rule": "at_most_one", "names": names }),
        Rule::AtLeastOne(names) => json!({ "rule": "at_least_one", "names": names }),
    }
}
