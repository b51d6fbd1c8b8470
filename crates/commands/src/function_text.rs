//! Run-time function texts: object names in them are held as references, so that they follow a
//! renaming. Objects of several classes may share a name: the function and the argument decide which
//! of them is meant.

use model::{Database, FunctionText, ObjectId, Piece};
use schema::{Class, referred};
use syntax::function::Calls;
use text::Diagnostic;

use crate::lookup;

/// Words that are never objects.
const RESERVED: &[&str] = &["time", "pi", "dtor", "rtod", "mode", "d"];

/// A function text with its names bound, and a warning for each name that means no object.
pub fn bind(database: &Database, text: &str) -> (FunctionText, Vec<Diagnostic>) {
    let mut pieces = Vec::new();
    let mut plain = String::new();
    let mut troubles = Vec::new();
    let mut calls = Calls::default();
    let mut rest = text;
    let mut before: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let glued = before.is_some_and(|b| b.is_ascii_alphanumeric() || b == '_' || b == '.' || b == '"');
        let second = rest.chars().nth(1);
        let dotted = c == '.' && !glued && second.is_some_and(|s| s.is_ascii_alphabetic() || s == '_' || s == '"');
        let bare = !glued && (c.is_ascii_alphabetic() || c == '_');
        if !dotted && !bare {
            let (one, after) = rest.split_at(c.len_utf8());
            plain.push(c);
            calls.read(one);
            before = Some(c);
            rest = after;
            continue;
        }
        let (name, after) = rest.split_at(name_length(rest));
        let call = !dotted && after.trim_start().starts_with('(');
        let wanted = calls.place().map_or(&[][..], |(function, argument)| referred(function, argument));
        let reserved = !dotted && wanted.is_empty() && RESERVED.iter().any(|r| r.eq_ignore_ascii_case(name));
        let found = if call || reserved { Ok(None) } else { object(database, name, wanted) };
        if let Ok(Some((id, used))) = found {
            if !plain.is_empty() {
                pieces.push(Piece::Text(std::mem::take(&mut plain)));
            }
            pieces.push(Piece::Object(id));
            calls.read_object();
            calls.read(&name[used..]);
            plain.push_str(&name[used..]);
        } else {
            troubles.extend(found.err());
            calls.read(name);
            plain.push_str(name);
        }
        before = name.chars().last();
        rest = after;
    }
    if !plain.is_empty() {
        pieces.push(Piece::Text(plain));
    }
    (FunctionText { pieces }, troubles)
}

/// Length in bytes of a name with its dots and quoted steps.
fn name_length(text: &str) -> usize {
    let mut quoted = false;
    for (i, c) in text.char_indices() {
        if c == '"' {
            quoted = !quoted;
        } else if !(quoted || c.is_ascii_alphanumeric() || c == '_' || c == '.') {
            return i;
        }
    }
    text.len()
}

/// The object that a name means, and how much of the name that is; nothing where a name may be
/// something else.
fn object(database: &Database, name: &str, wanted: &[&str]) -> Result<Option<(ObjectId, usize)>, Diagnostic> {
    let whole = |id| Ok(Some((id, name.len())));
    for statement in wanted {
        match lookup::search_for(database, name, &|class| class.statement == Some(*statement)).as_slice() {
            [] => {}
            [one] => return whole(*one),
            many => return Err(several(database, name, many)),
        }
    }
    // A design variable may stand for anything.
    if let Some(variable) = lookup::search_one(database, name, "variable") {
        return whole(variable);
    }
    let dotted = name.starts_with('.');
    let other = if dotted { longest(database, name) } else { near(database, name).map(|id| (id, name.len())) };
    match (wanted.first(), other) {
        (Some(statement), other) => Err(missing(database, name, statement, other.map(|(id, _)| id))),
        (None, None) if dotted => {
            let message = format!("the function names `{name}`, which does not exist");
            Err(Diagnostic::warning("name/not-found", message))
        }
        (None, other) => Ok(other),
    }
}

/// The warning that a name means nothing of the class that the argument wants.
fn missing(database: &Database, name: &str, statement: &str, other: Option<ObjectId>) -> Diagnostic {
    let word = statement.to_ascii_lowercase();
    let message = format!("the function names the {word} `{name}`, which does not exist");
    let warning = Diagnostic::warning("name/not-found", message);
    match other {
        Some(id) => warning.note(format!("`{}` is a {}", database.full_name(id), database.object(id).class.word)),
        None => warning,
    }
}

fn several(database: &Database, name: &str, found: &[ObjectId]) -> Diagnostic {
    let names: Vec<String> = found.iter().take(8).map(|id| database.full_name(*id)).collect();
    let message = format!("`{name}` in the function may mean {}", names.join(", "));
    Diagnostic::warning("name/ambiguous", message).help(format!("write the full name, for example `{}`", names[0]))
}

/// The object of a full name, or of its longest beginning that has at least two steps; the rest
/// is a component (`.model.request.F1`).
fn longest(database: &Database, name: &str) -> Option<(ObjectId, usize)> {
    let mut end = name.trim_end_matches('.').len();
    loop {
        let head = name.get(..end)?;
        if let Some(id) = database.find(head, "any") {
            return Some((id, end));
        }
        end = head.rfind('.')?;
        if name[..end].matches('.').count() < 2 {
            return None;
        }
    }
}

/// A short name below the current part or the current model.
fn near(database: &Database, name: &str) -> Option<ObjectId> {
    let direct = [database.current("part"), database.current("model")];
    let steps = model::split_name(name);
    let any = |_: &Class| true;
    direct
        .into_iter()
        .flatten()
        .find_map(|parent| database.descend_to(Some(parent), &steps, &any))
        .or_else(|| if name.contains('.') { None } else { lookup::search_one(database, name, "marker") })
}
