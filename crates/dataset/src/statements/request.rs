//! REQUEST: two markers and what is recorded of them, or up to eight functions.

use model::{ObjectId, Value};
use schema::Kind;
use text::Diagnostic;

use super::{function_text, reference, texts, user_function};
use crate::{
    layout::Lines,
    read::{Builder, Entry, Form, Word, unquoted},
    write::Writer,
};

pub(super) fn request(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let kind = w.database.text(id, "output_type").map(str::to_ascii_uppercase);
    let of_markers = w.database.reference(id, "i_marker_name").is_some();
    if let Some(kind) = kind.filter(|_| of_markers) {
        lines.flag(&kind);
        reference(w, id, "i_marker_name", "I", lines);
        reference(w, id, "j_marker_name", "J", lines);
        reference(w, id, "r_marker_name", "RM", lines);
    }
    if let Some(comment) = w.database.text(id, "comment").filter(|c| !c.is_empty()) {
        lines.argument("COMMENT", comment);
    }
    let strings = [
        ("title", "TITLE"),
        ("component_names", "CNAMES"),
        ("component_units", "CUNITS"),
        ("component_labels", "CLABELS"),
    ];
    for (field, keyword) in strings {
        let words = texts(w.database, id, field);
        if words.iter().any(|word| !word.is_empty()) {
            if words.iter().any(|word| word.contains('"')) {
                let name = w.database.full_name(id);
                let message =
                    format!("quotes in `{field}` of `{name}` are written as `'`: a dataset has no way to say them");
                w.warn("dataset/quote-not-written", message);
            }
            if keyword == "TITLE" {
                let words: Vec<_> =
                    words.iter().map(|word| if is_plain(word) { word.clone() } else { quoted(word) }).collect();
                lines.argument(keyword, &words.join(":"));
            } else {
                lines.list(keyword, &words.iter().map(|word| quoted(word)).collect::<Vec<_>>());
            }
        }
    }
    if let Some(name) = w.database.text(id, "results_name").filter(|n| !n.is_empty()) {
        lines.argument("RESULTS_NAME", name);
    }
    if let Some(call) = user_function(w, id) {
        lines.function("FUNCTION", &call);
        if let Some(routine) = w.database.text(id, "routine").filter(|r| !r.is_empty()) {
            lines.end_function();
            lines.argument("ROUTINE", routine);
        }
        return;
    }
    if w.database.value(id, "variable_name").is_some_and(|v| *v != Value::Nothing) {
        let name = w.database.full_name(id);
        w.warn("dataset/argument-not-written", format!("`variable_name` of `{name}` is not written yet"));
    }
    let (mut earlier, mut left_out) = (false, false);
    for field in w.database.object(id).class.fields().filter(|field| field.kind == Kind::Function) {
        let Some(keyword) = field.keyword else { continue };
        let (text, troubles) = w.attempt(|w| function_text(w, id, field.name));
        if !troubles.is_empty() {
            // The other components are as good without this one.
            w.leave_out(&format!("{keyword} = {text}"), troubles);
            left_out = true;
        } else if !text.is_empty() {
            if earlier {
                lines.end_function();
            }
            lines.function(keyword, &text);
            earlier = true;
        }
    }
    if left_out && !earlier && !of_markers {
        let name = w.database.full_name(id);
        w.fail("dataset/empty-request", format!("`{name}` has no component that can be written"));
    }
}

fn quoted(word: &str) -> String {
    format!("\"{}\"", word.replace('"', "'").replace(['\n', '\r'], " "))
}

/// Whether a heading may stand without quotes: nothing in it parts, ends or joins anything.
fn is_plain(word: &str) -> bool {
    !word.contains(|c: char| c.is_whitespace() || matches!(c, ':' | ',' | '"' | '!' | '\\' | ';' | '=' | '(' | ')'))
}

/// Headings between colons; those within quotes are part of a heading.
fn headings(text: &str) -> Vec<String> {
    let mut in_quotes = false;
    let parted = text.split(|c: char| {
        in_quotes ^= c == '"';
        c == ':' && !in_quotes
    });
    parted.map(|word| unquoted(word).to_string()).collect()
}

/// What is recorded of two markers.
pub(super) const KINDS: [&str; 4] = ["DISPLACEMENT", "VELOCITY", "ACCELERATION", "FORCE"];

pub(super) fn words() -> Vec<Word> {
    let kinds = KINDS.map(|kind| (kind, Form::Flag));
    kinds.into_iter().chain([("FUNCTION", Form::Function), ("ROUTINE", Form::Value)]).collect()
}

pub(super) fn read<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let (marker, kind) = (e.statement.argument("I").is_some(), KINDS.iter().any(|kind| e.statement.has(kind)));
    if kind {
        b.needs(e, "I");
    } else if marker {
        let message = format!("{} does not say what it records of its markers", e.name());
        let unknown = Diagnostic::error("dataset/no-kind", message).at(e.statement.head, "nothing is recorded");
        b.report(unknown.help(format!("it is one of {}", KINDS.join(", "))));
    }
    if let Some(word) = e.one_of(&KINDS) {
        b.store(e.id, "output_type", Value::Text(word.to_ascii_lowercase()));
    }
    if let Some(argument) = e.take("TITLE") {
        b.store(e.id, "title", Value::Texts(headings(&argument.value(b.text))));
    }
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
    if let (Some(field), Some(argument)) = (Builder::field(e, "routine"), e.take("ROUTINE")) {
        b.set_text(e, field, argument);
    }
}
