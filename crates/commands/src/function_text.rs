//! Run-time function texts: object names in them are held as references, so that they follow a
//! renaming.

use model::{Database, FunctionText, ObjectId, Piece};

use crate::lookup;

/// Words that are never objects.
const RESERVED: &[&str] = &["time", "pi", "dtor", "rtod", "mode", "d"];

/// A function text with its names bound, and the dotted names that mean no object.
pub fn bind(database: &Database, text: &str) -> (FunctionText, Vec<String>) {
    let mut pieces = Vec::new();
    let mut plain = String::new();
    let mut unknown = Vec::new();
    let mut rest = text;
    let mut before: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let glued = before.is_some_and(|b| b.is_ascii_alphanumeric() || b == '_' || b == '.' || b == '"');
        let second = rest.chars().nth(1);
        let dotted = c == '.' && !glued && second.is_some_and(|s| s.is_ascii_alphabetic() || s == '_' || s == '"');
        let bare = !glued && (c.is_ascii_alphabetic() || c == '_');
        if !dotted && !bare {
            plain.push(c);
            before = Some(c);
            rest = &rest[c.len_utf8()..];
            continue;
        }
        let length = name_length(rest);
        let (name, after) = rest.split_at(length);
        let found = if dotted {
            bind_dotted(database, name)
        } else if after.trim_start().starts_with('(') || RESERVED.iter().any(|r| r.eq_ignore_ascii_case(name)) {
            None
        } else {
            near(database, name).map(|id| (id, name.len()))
        };
        if let Some((id, used)) = found {
            if !plain.is_empty() {
                pieces.push(Piece::Text(std::mem::take(&mut plain)));
            }
            pieces.push(Piece::Object(id));
            plain.push_str(&name[used..]);
        } else {
            if dotted {
                unknown.push(name.to_string());
            }
            plain.push_str(name);
        }
        before = name.chars().last();
        rest = after;
    }
    if !plain.is_empty() {
        pieces.push(Piece::Text(plain));
    }
    (FunctionText { pieces }, unknown)
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

/// The object of a full name, or of its longest beginning that has at least two steps; the rest
/// is a component (`.model.request.F1`).
fn bind_dotted(database: &Database, name: &str) -> Option<(ObjectId, usize)> {
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
    direct
        .into_iter()
        .flatten()
        .find_map(|parent| database.descend(Some(parent), &steps, "any"))
        .or_else(|| if name.contains('.') { None } else { lookup::search_one(database, name, "marker") })
}
