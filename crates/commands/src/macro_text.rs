//! The text of a macro: the parameters it declares by `$name:t=...`, and values in their places.

/// One parameter of a macro.
#[derive(Clone, Debug, Default)]
pub(crate) struct Formal {
    pub name: String,
    /// `real`, `marker`, `list(a,b)`, ... in lower case; empty if nothing is said.
    pub kind: String,
    pub least: usize,
    pub most: usize,
    pub default: Option<String>,
    /// `ud`: the value given last becomes the default.
    pub updated: bool,
    pub bounds: Vec<(Bound, f64)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bound {
    Above,
    AtLeast,
    Below,
    AtMost,
}

/// Something in the declaration of a parameter that is not understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Doubt {
    /// Where in the text, and how long.
    pub at: usize,
    pub length: usize,
    pub parameter: String,
    pub what: What,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// Its type, for the caller to know or not.
    Type,
    UnknownQualifier,
    /// The value of a qualifier that exists.
    Value,
    /// A default with blanks and without quotes.
    Unquoted(String),
}

/// Finds the parameters of a macro in the order of their first use.
pub(crate) fn find_formals(text: &str) -> Vec<Formal> {
    declarations(text).0
}

/// The parameters of a macro, and what there is to be said of their declarations.
pub(crate) fn declarations(text: &str) -> (Vec<Formal>, Vec<Doubt>) {
    let (mut found, mut doubts): (Vec<Formal>, Vec<Doubt>) = (Vec::new(), Vec::new());
    let mut from = 0;
    while let Some(at) = text[from..].find('$').map(|a| a + from) {
        from = at + 1;
        if text[..at].ends_with('\\') {
            continue;
        }
        let (name, mut qualifiers, _) = placeholder(&text[from..]);
        if name.is_empty() || name == "_self" || found.iter().any(|f| f.name.eq_ignore_ascii_case(name)) {
            continue;
        }
        let offset = qualifiers.as_ptr() as usize - text.as_ptr() as usize;
        let unquoted = is_header(text, at).then(|| whole_default(&text[offset..], qualifiers)).flatten();
        if let Some(longer) = unquoted {
            qualifiers = longer;
        }
        let (formal, more) = formal(name, qualifiers, offset);
        doubts.extend(more);
        if unquoted.is_some() {
            let value = formal.default.clone().unwrap_or_default();
            let at = offset + qualifiers.len() - value.len();
            let what = What::Unquoted(value.clone());
            doubts.push(Doubt { at, length: value.len(), parameter: name.into(), what });
        }
        found.push(formal);
    }
    (found, doubts)
}

/// Whether the dollar at an offset begins a line of the header: only `!` is before it.
fn is_header(text: &str, dollar: usize) -> bool {
    text[..dollar].rsplit('\n').next().is_some_and(|before| before.trim() == "!")
}

/// The qualifiers with the rest of their line, where that goes on with the default of a text: it
/// was written without quotes. `line` begins with the qualifiers.
fn whole_default<'t>(line: &'t str, qualifiers: &str) -> Option<&'t str> {
    let last = split_qualifiers(qualifiers).last().map(|(_, last)| last)?;
    let (key, value) = last.split_once('=')?;
    let is_text = split_qualifiers(qualifiers).any(|(_, q)| {
        let q = q.to_ascii_lowercase();
        q.split_once('=').is_some_and(|(key, kind)| key_named(key) == Some(Key::Type) && kind.trim() == "string")
    });
    if !is_text || !matches!(key_named(key), Some(Key::Default | Key::Updated)) || value.trim_start().starts_with('"') {
        return None;
    }
    let line = line.split(['\n', '\r', '!']).next().unwrap_or("").trim_end();
    (line.len() > qualifiers.trim_end().len()).then_some(line)
}

/// Reads `name:t=real:c=1` or `'name:...'` behind a dollar sign: name, qualifiers, length.
fn placeholder(text: &str) -> (&str, &str, usize) {
    if let Some(inner) = text.strip_prefix('\'')
        && let Some(close) = inner.find('\'')
    {
        let (name, qualifiers) = inner[..close].split_once(':').unwrap_or((&inner[..close], ""));
        return (name, qualifiers, close + 2);
    }
    let end = text.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(text.len());
    let name = &text[..end];
    // A colon that no qualifier follows belongs to the text behind the parameter.
    let begins = text[end..].strip_prefix(':').and_then(|rest| rest.split_once('='));
    let is_key = |(key, _): (&str, &str)| !key.is_empty() && key.chars().all(|c| c.is_ascii_alphabetic() || c == '_');
    if name.is_empty() || !begins.is_some_and(is_key) {
        return (name, &text[end..end], end);
    }
    let mut depth = 0usize;
    let (mut quoted, mut before) = (false, ':');
    let stop = text[end..]
        .find(|c: char| {
            // A quote opens a default; elsewhere it is the end of the string the parameter stands in.
            let closes = c == '"' && !quoted && !matches!(before, '=' | ',' | '(');
            match c {
                '"' if !closes => quoted = !quoted,
                '(' => depth += 1,
                ')' => depth = depth.saturating_sub(1),
                _ => {}
            }
            before = c;
            closes || !quoted && depth == 0 && c.is_whitespace()
        })
        .map_or(text.len(), |s| s + end);
    // A comma before a blank goes on with the list that the parameter stands in.
    let stop = end + text[end..stop].trim_end_matches(',').len();
    (name, &text[end + 1..stop], stop)
}

/// The qualifiers between colons, each with its offset; colons in quotes and parentheses part none.
fn split_qualifiers(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let (mut depth, mut quoted) = (0usize, false);
    let parts = text.split(move |c: char| {
        match c {
            '"' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ':' && !quoted && depth == 0
    });
    parts.scan(0, |offset, part| {
        let at = *offset;
        *offset += part.len() + 1;
        Some((at, part))
    })
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Key {
    Type,
    Count,
    Default,
    /// Spelled `u` in the macros of the vehicle products.
    Updated,
    Range,
    Bound(Bound),
}

/// Words of qualifiers, for guesses.
pub(crate) const KEYS: [&str; 9] = ["t", "c", "d", "ud", "r", "gt", "ge", "lt", "le"];

fn key_named(word: &str) -> Option<Key> {
    Some(match word.trim().to_ascii_lowercase().as_str() {
        "t" | "type" => Key::Type,
        "c" | "count" => Key::Count,
        "d" | "default" => Key::Default,
        "u" | "ud" | "updated_default" => Key::Updated,
        "r" | "range" => Key::Range,
        word => Key::Bound(bound_named(word)?),
    })
}

/// `n`, `n,m`, or `n,0` for n or more.
fn count_of(value: &str) -> Option<(usize, usize)> {
    let mut parts = value.split(',').map(|p| p.trim().parse::<usize>().ok());
    let (least, most) = (parts.next()??, parts.next());
    Some(match (least, most) {
        (0, None | Some(Some(0))) => (0, usize::MAX),
        (n, Some(Some(0))) => (n, usize::MAX),
        (n, Some(Some(m))) => (n, m),
        (n, None) => (n, n),
        (_, Some(None)) => return None,
    })
}

/// `gt(0)`, `ge(0),le(1)`: the long form of bounds.
fn range_of(value: &str) -> Option<Vec<(Bound, f64)>> {
    let bound = |part: &str| {
        let (word, limit) = part.trim_start_matches(',').split_once('(')?;
        Some((bound_named(word)?, limit.trim().parse().ok()?))
    };
    value.split_terminator(')').map(bound).collect()
}

fn formal(name: &str, qualifiers: &str, offset: usize) -> (Formal, Vec<Doubt>) {
    let mut formal = Formal { name: name.into(), least: 1, most: 1, ..Formal::default() };
    let (mut doubts, mut count) = (Vec::new(), None);
    for (at, qualifier) in split_qualifiers(qualifiers).filter(|(_, q)| !q.trim().is_empty()) {
        let mut doubt = |at: usize, length, what| {
            doubts.push(Doubt { at: offset + at, length, parameter: name.into(), what });
        };
        let (word, value) = qualifier.split_once('=').unwrap_or((qualifier, ""));
        let (start, value) = (at + qualifier.len() - value.len(), value.trim());
        let understood = match key_named(word).filter(|_| qualifier.contains('=')) {
            None => {
                doubt(at, word.len(), What::UnknownQualifier);
                true
            }
            Some(Key::Type) => {
                formal.kind = value.to_ascii_lowercase();
                doubt(start, value.len(), What::Type);
                true
            }
            Some(Key::Count) => {
                count = count_of(value);
                count.is_some()
            }
            Some(key @ (Key::Default | Key::Updated)) => {
                formal.default = Some(value.trim_matches('"').to_string());
                formal.updated = key == Key::Updated;
                true
            }
            Some(Key::Range) => range_of(value).map(|bounds| formal.bounds.extend(bounds)).is_some(),
            Some(Key::Bound(bound)) => value.parse().map(|limit| formal.bounds.push((bound, limit))).is_ok(),
        };
        if !understood {
            doubt(start, value.len(), What::Value);
        }
    }
    let points = matches!(formal.kind.as_str(), "location" | "orientation");
    (formal.least, formal.most) = count.unwrap_or(if points { (3, 3) } else { (1, 1) });
    (formal, doubts)
}

fn bound_named(word: &str) -> Option<Bound> {
    Some(match word.trim().to_ascii_lowercase().as_str() {
        "gt" => Bound::Above,
        "ge" => Bound::AtLeast,
        "lt" => Bound::Below,
        "le" => Bound::AtMost,
        _ => return None,
    })
}

/// The body with its placeholders replaced.
pub(crate) fn substitute(body: &str, values: &[(String, String)]) -> String {
    let mut text = String::with_capacity(body.len());
    for line in body.lines() {
        if line.trim_start().starts_with('!') {
            // No parameter is put into a comment; it stays, so that line numbers and echoes are right.
            text.push_str(line);
            text.push('\n');
            continue;
        }
        let mut rest = line;
        while let Some(at) = rest.find('$') {
            if rest[..at].ends_with('\\') {
                text.push_str(&rest[..at - 1]);
                text.push('$');
                rest = &rest[at + 1..];
                continue;
            }
            text.push_str(&rest[..at]);
            let (name, _, length) = placeholder(&rest[at + 1..]);
            match values.iter().find(|(n, _)| n.eq_ignore_ascii_case(name)) {
                Some((_, value)) if !name.is_empty() => text.push_str(value),
                _ => text.push_str(&rest[at..=at + length]),
            }
            rest = &rest[at + 1 + length..];
        }
        text.push_str(rest);
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_behind_a_type_belongs_to_the_list() {
        assert_eq!(placeholder("x:t=real, 0, 0"), ("x", "t=real", 8));
        assert_eq!(placeholder("x:t=real:c=1,3 y"), ("x", "t=real:c=1,3", 14));
        assert_eq!(placeholder("x:$y:z"), ("x", "", 1));
    }

    #[test]
    fn parameters_are_declared_by_their_first_use() {
        let formals =
            find_formals("!$size:t=real:d=1.5:gt=0\nforce attributes size_of_icons = $size name=$'f:t=force'_x \\$no");
        assert_eq!(formals.len(), 2);
        assert_eq!(formals[0].default.as_deref(), Some("1.5"));
        assert_eq!(formals[0].bounds, vec![(Bound::Above, 0.0)]);
        assert_eq!((formals[1].name.as_str(), formals[1].kind.as_str()), ("f", "force"));
    }

    #[test]
    fn qualifiers_are_read_in_all_spellings() {
        let one = |text: &str| declarations(text).0.remove(0);
        let steps = one("! $n:T=integer:u=10:r=ge(0),le(1.5):C=2,0");
        assert_eq!((steps.kind.as_str(), steps.updated, steps.default.as_deref()), ("integer", true, Some("10")));
        assert_eq!((steps.least, steps.most), (2, usize::MAX));
        assert_eq!(steps.bounds, vec![(Bound::AtLeast, 0.0), (Bound::AtMost, 1.5)]);
        assert_eq!(one("!$p:t=location").most, 3);
        assert_eq!(one("!$p:c=0:t=location").most, usize::MAX);
        assert_eq!(one("!$f:t=string:d=\"C:\\x y\"").default.as_deref(), Some("C:\\x y"));
    }

    #[test]
    fn what_is_not_understood_is_placed() {
        let text = "!$x:zz=4:c=two:gt=a\n!$s:t=string:d=hello world ! said\n!$n:t=real:d=2 metres";
        let doubts: Vec<_> = declarations(text).1.into_iter().filter(|d| d.what != What::Type).collect();
        let found: Vec<(&str, &What)> = doubts.iter().map(|d| (&text[d.at..d.at + d.length], &d.what)).collect();
        let unquoted = What::Unquoted("hello world".into());
        let expected =
            [("zz", &What::UnknownQualifier), ("two", &What::Value), ("a", &What::Value), ("hello world", &unquoted)];
        assert_eq!(found, expected);
    }

    #[test]
    fn values_stand_where_parameters_were() {
        let values = [("a".to_string(), "5".to_string())];
        assert_eq!(substitute("x = $a, PART_$'a'_2, \\$a", &values), "x = 5, PART_5_2, $a\n");
    }
}
