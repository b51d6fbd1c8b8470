//! Statements that follow from the schema: each field with a keyword is an argument.

use model::{ObjectId, Value};
use schema::{Default, Field, Kind};

use super::{function_or_user, function_text, numbers, reference, texts};
use crate::{layout::Lines, write::Writer};

/// Arguments in the order exports write them, where that is not the order of the fields.
const ORDER: &[(&str, &[&str])] = &[(
    "BEAM",
    &[
        "I",
        "J",
        "LENGTH",
        "IXX",
        "IYY",
        "IZZ",
        "AREA",
        "ASY",
        "ASZ",
        "EMODULUS",
        "GMODULUS",
        "CRATIO",
        "CMATRIX",
        "FORMULATION",
    ],
)];

/// Statements in which a number that is not given is zero, whatever a command fills in.
const ZERO_IF_LEFT_OUT: &[&str] = &["BUSHING", "SPRINGDAMPER"];

pub(crate) fn zero_if_left_out(statement: &str) -> bool {
    ZERO_IF_LEFT_OUT.contains(&statement)
}

/// Appends all arguments of an object.
pub(super) fn arguments(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    chosen(w, id, lines, |_| true);
}

/// Appends the arguments of an object but for some.
pub(super) fn without(w: &mut Writer<'_>, id: ObjectId, keywords: &[&str], lines: &mut Lines) {
    chosen(w, id, lines, |field| !field.keyword.is_some_and(|keyword| keywords.contains(&keyword)));
}

/// Appends the arguments of an object but for its markers.
pub(super) fn without_ends(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    chosen(w, id, lines, |field| !matches!(field.keyword, Some("I" | "J")));
}

fn chosen(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines, wanted: impl Fn(&Field) -> bool) {
    let class = w.database.object(id).class;
    let mut fields: Vec<&Field> = class.fields().filter(|f| f.keyword.is_some() && wanted(f)).collect();
    fields.dedup_by_key(|f| f.name);
    if let Some((_, order)) = ORDER.iter().find(|(statement, _)| class.statement == Some(*statement)) {
        fields.sort_by_key(|f| order.iter().position(|k| Some(*k) == f.keyword).unwrap_or(order.len()));
    }
    for field in fields {
        argument(w, id, field, lines);
    }
}

fn argument(w: &mut Writer<'_>, id: ObjectId, field: &Field, lines: &mut Lines) {
    let Some(keyword) = field.keyword else { return };
    match field.kind {
        // The routine is written with the function it belongs to.
        Kind::Text if keyword == "ROUTINE" => {}
        Kind::Function if field.name == "function" => function_or_user(w, id, lines),
        Kind::Function => {
            let text = function_text(w, id, field.name);
            if !text.is_empty() {
                lines.function(keyword, &text);
                lines.end_function();
            }
        }
        Kind::Object(..) => match w.database.value(id, field.name).map(Value::objects) {
            Some(objects) if objects.len() > 1 => {
                let ids: Vec<_> = objects.iter().map(|o| w.id_of(id, *o)).collect();
                lines.list(keyword, &ids);
            }
            _ => reference(w, id, field.name, keyword, lines),
        },
        Kind::Boolean(..) => {
            if w.database.flag(id, field.name) == Some(true) {
                lines.flag(keyword);
            }
        }
        Kind::Choice(_) => {
            if let Some(word) = w.database.text(id, field.name) {
                lines.argument(keyword, &word.to_ascii_uppercase());
            }
        }
        Kind::Text | Kind::File => {
            let words = texts(w.database, id, field.name);
            if words.iter().any(|text| !text.is_empty()) {
                lines.list(keyword, &words);
            }
        }
        Kind::Real | Kind::Integer | Kind::Location | Kind::Orientation | Kind::Any => {
            // A number that is zero unless given is written where it is not.
            let zero = w.database.numbers(id, field.name).is_some_and(|list| list.iter().all(|x| *x == 0.0));
            let statement = w.database.object(id).class.statement;
            let left_out = ZERO_IF_LEFT_OUT.iter().any(|s| statement == Some(s));
            if zero && (left_out || field.default == Default::Number(0.0)) {
                return;
            }
            if let Some(values) = numbers(w, id, field) {
                lines.list(keyword, &values);
            }
        }
    }
}
