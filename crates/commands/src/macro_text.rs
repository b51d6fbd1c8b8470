//! The text of a macro: the parameters it declares by `$name:t=...`, and values in their places.

/// One parameter of a macro.
#[derive(Clone, Debug, Default)]
pub(crate) struct Formal {
    pub name: String,
    /// `real`, `marker`, `list(a,b)`, ...; real if nothing is said.
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

/// Finds the parameters of a macro in the order of their first use.
pub(crate) fn find_formals(text: &str) -> Vec<Formal> {
    let mut found: Vec<Formal> = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find('$') {
        let escaped = rest[..at].ends_with('\\');
        rest = &rest[at + 1..];
        if escaped {
            continue;
        }
        let (name, qualifiers, _) = placeholder(rest);
        if !name.is_empty() && name != "_self" && !found.iter().any(|f| f.name.eq_ignore_ascii_case(name)) {
            found.push(formal(name, qualifiers));
        }
    }
    found
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
    if !text[end..].starts_with(':') || name.is_empty() {
        return (name, "", end);
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

fn formal(name: &str, qualifiers: &str) -> Formal {
    let mut formal = Formal { name: name.into(), kind: "real".into(), least: 1, most: 1, ..Formal::default() };
    for qualifier in qualifiers.split(':') {
        let Some((key, value)) = qualifier.split_once('=') else { continue };
        let value = value.trim();
        match key.trim().to_ascii_lowercase().as_str() {
            "t" => formal.kind = value.to_ascii_lowercase(),
            "c" => {
                let mut parts = value.split(',').map(|p| p.trim().parse::<usize>().unwrap_or(1));
                let least = parts.next().unwrap_or(1);
                let most = parts.next();
                (formal.least, formal.most) = match (least, most) {
                    (0, None | Some(0)) => (0, usize::MAX),
                    (n, Some(0)) => (n, usize::MAX),
                    (n, Some(m)) => (n, m),
                    (n, None) => (n, n),
                };
            }
            "d" => formal.default = Some(value.trim_matches('"').to_string()),
            "ud" => {
                formal.default = Some(value.trim_matches('"').to_string());
                formal.updated = true;
            }
            "r" => {
                // `r=gt(0)` is the long form of `gt=0`.
                let (word, limit) = value.split_once('(').unwrap_or((value, ""));
                if let (Some(bound), Ok(limit)) = (bound_named(word), limit.trim_end_matches(')').trim().parse()) {
                    formal.bounds.push((bound, limit));
                }
            }
            word => {
                if let (Some(bound), Ok(limit)) = (bound_named(word), value.parse()) {
                    formal.bounds.push((bound, limit));
                }
            }
        }
    }
    formal
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

/// The body with its placeholders replaced; header and declarations are left out.
pub(crate) fn substitute(body: &str, values: &[(String, String)]) -> String {
    let mut text = String::with_capacity(body.len());
    for line in body.lines() {
        if line.trim_start().starts_with('!') {
            // Kept as a comment: line numbers stay, and a command that goes on behind it goes on.
            text.push_str("!\n");
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
    fn values_stand_where_parameters_were() {
        let values = [("a".to_string(), "5".to_string())];
        assert_eq!(substitute("x = $a, PART_$'a'_2, \\$a", &values), "x = 5, PART_5_2, $a\n");
    }
}
