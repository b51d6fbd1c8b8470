//! VFORCE, VTORQUE and GFORCE: components along a marker, each a function.

use model::ObjectId;
use schema::Kind;
use text::Diagnostic;

use super::{function_text, reference, user_function};
use crate::{
    layout::Lines,
    read::{Builder, Entry, Form, Word},
    write::Writer,
};

pub(super) fn vector(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    reference(w, id, "i_marker_name", "I", lines);
    reference(w, id, "j_floating_marker_name", "JFLOAT", lines);
    reference(w, id, "ref_marker_name", "RM", lines);
    let class = w.database.object(id).class;
    let components = class.fields().filter(|f| f.kind == Kind::Function);
    let components: Vec<_> = components
        .filter_map(|f| Some((f.keyword?, function_text(w, id, f.name))))
        .filter(|(_, text)| !text.is_empty())
        .collect();
    let name = w.database.full_name(id);
    if w.database.reference(id, "j_floating_marker_name").is_none() {
        w.fail("dataset/no-marker", format!("`{name}` has no floating marker"));
    }
    if components.is_empty() {
        let Some(call) = user_function(w, id) else {
            w.fail("dataset/no-function", format!("`{name}` has no function"));
            return;
        };
        lines.function("FUNCTION", &call);
        if let Some(routine) = w.database.text(id, "routine").filter(|r| !r.is_empty()) {
            lines.end_function();
            lines.argument("ROUTINE", routine);
        }
        return;
    }
    let last = components.len() - 1;
    for (k, (keyword, text)) in components.iter().enumerate() {
        lines.function(keyword, text);
        if k < last {
            lines.end_function();
        }
    }
}

pub(super) const WORDS: &[Word] = &[("FUNCTION", Form::Function)];

pub(super) fn read<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let given = |field: &schema::Field| field.keyword.is_some_and(|keyword| e.statement.argument(keyword).is_some());
    let components = || e.class.fields().filter(|field| field.kind == Kind::Function);
    if e.statement.argument("FUNCTION").is_none() && components().next().is_some() && !components().any(given) {
        let keywords: Vec<_> = components().filter_map(|field| field.keyword).collect();
        let message = format!("{} has no function", e.name());
        let nothing = Diagnostic::error("dataset/missing-argument", message).at(e.statement.head, "it does nothing");
        b.report(nothing.help(format!("give one of {}, or `FUNCTION = USER(...)`", keywords.join(", "))));
    }
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
}
