//! Functions of texts. Positions count characters from 1.

use model::Value;

use super::{Arguments, Function, function};
use crate::pattern::glob;
use crate::{
    arithmetic::{flag, text_of},
    scope::Outcome,
};

pub const TABLE: &[Function] = &[
    function("CHR", "code", "character of a code", chr),
    function("ON_OFF", "flag", "\"on\" or \"off\"", |a| text(if a.number(0)? == 0.0 { "off" } else { "on" })),
    function("STOI", "text", "text to integer", |a| {
        let given = a.text(0)?;
        given
            .trim()
            .parse::<f64>()
            .ok()
            .filter(|x| x.abs() < 9.0e15)
            .map(|x| Value::Integer(x as i64))
            .ok_or_else(|| a.error(format!("\"{given}\" is not an integer")))
    }),
    function("STOO", "text", "text to the object it names", |a| match &a.values[0] {
        Value::Texts(_) | Value::Objects(_) => Ok(Value::Objects(a.objects(0)?)),
        _ => Ok(Value::Object(a.object(0)?)),
    }),
    function("STOR", "text", "text to real", |a| {
        let given = a.text(0)?;
        parse_real(&given).map(Value::Number).ok_or_else(|| a.error(format!("\"{given}\" is not a number")))
    }),
    function("STR", "value", "text of a value", |a| Ok(Value::Text(text_of(&a.values[0], &a.evaluator.scope)?))),
    function("STR_CASE", "text, kind", "text in another case: 1 upper, 2 lower, 3 mixed, 4 sentence", case),
    function("STR_CHR", "code", "character of a code", chr),
    function("STR_COMPARE", "text, text", "order of two texts ignoring case: 0 if equal", |a| {
        let (x, y) = (a.text(0)?.to_ascii_lowercase(), a.text(1)?.to_ascii_lowercase());
        Ok(Value::Integer(x.cmp(&y) as i64))
    }),
    function("STR_DELETE", "text, start, length", "text without a stretch of it", |a| {
        let (given, from, count) = (characters(a)?, a.integer(1)?, a.integer(2)?);
        let (start, end) = range(from, count, given.len());
        Ok(Value::Text(given[..start].iter().chain(&given[end..]).collect()))
    }),
    function("STR_FIND", "text, part", "position of a part in a text, 0 if it is not there", |a| {
        Ok(Value::Integer(occurrence(a, 1)?))
    }),
    function("STR_FIND_COUNT", "text, part", "how often a part occurs", |a| {
        let (base, part) = (a.text(0)?, a.text(1)?);
        Ok(Value::Integer(if part.is_empty() { 0 } else { base.matches(part.as_str()).count() as i64 }))
    }),
    function("STR_FIND_IN_STRINGS", "texts, text", "position of a text in a list", |a| {
        let (list, wanted) = (a.texts(0)?, a.text(1)?);
        Ok(Value::Integer(list.iter().position(|t| *t == wanted).map_or(0, |i| i as i64 + 1)))
    }),
    function("STR_FIND_N", "text, part, n", "position of the n-th occurrence of a part", |a| {
        let n = a.integer(2)?;
        Ok(Value::Integer(occurrence(a, n)?))
    }),
    function("STR_INSERT", "text, part, position", "text with another put into it", |a| {
        let (given, part, place) = (characters(a)?, a.text(1)?, a.integer(2)?);
        let (at, _) = range(place, 0, given.len());
        Ok(Value::Text(given[..at].iter().copied().chain(part.chars()).chain(given[at..].iter().copied()).collect()))
    }),
    function("STR_IS_REAL", "text", "1 if the text is a number", |a| Ok(flag(parse_real(&a.text(0)?).is_some()))),
    function("STR_IS_SPACE", "text", "1 if the text is blank", |a| {
        Ok(flag(a.text(0)?.chars().all(char::is_whitespace)))
    }),
    function("STR_LENGTH", "text", "number of characters", |a| Ok(Value::Integer(characters(a)?.len() as i64))),
    function("STR_MATCH", "pattern, text", "1 if a text fits a pattern with wildcards", |a| {
        Ok(flag(glob(&a.text(0)?, &a.text(1)?)))
    }),
    function("STR_MERGE_STRINGS", "separator, texts", "texts joined into one", |a| {
        Ok(Value::Text(a.texts(1)?.join(&a.text(0)?)))
    }),
    function("STR_REMOVE_WHITESPACE", "text", "text without blanks at its ends", |a| text(a.text(0)?.trim())),
    function("STR_REPLACE_ALL", "text, from, to", "text with every occurrence of a part replaced", |a| {
        let (base, from, to) = (a.text(0)?, a.text(1)?, a.text(2)?);
        if from.is_empty() { Ok(Value::Text(base)) } else { Ok(Value::Text(base.replace(&from, &to))) }
    }),
    function("STR_SPLIT", "text, separator", "pieces of a text between separators", |a| {
        let (base, separator) = (a.text(0)?, a.text(1)?);
        if separator.is_empty() {
            return Err(a.error("the separator is empty"));
        }
        Ok(Value::Texts(base.split(separator.as_str()).map(|t| t.trim().to_string()).collect()))
    }),
    function("STR_SPRINTF", "format, values", "values written by a format as in C", |a| {
        let (format, values) = (a.text(0)?, a.texts(1)?);
        super::print_format::sprintf(&format, &values).map(Value::Text).map_err(|e| a.error(e))
    }),
    function("STR_SUBSTR", "text, start, length", "a stretch of a text", |a| {
        let (given, from, count) = (characters(a)?, a.integer(1)?, a.integer(2)?);
        let (start, end) = range(from, count, given.len());
        Ok(Value::Text(given[start..end].iter().collect()))
    }),
    function("STR_XLATE", "text, from, to", "text with characters replaced one for one", |a| {
        let (base, from, to) = (a.text(0)?, a.text(1)?, a.text(2)?);
        let (from, to): (Vec<char>, Vec<char>) = (from.chars().collect(), to.chars().collect());
        if from.len() != to.len() {
            return Err(a.error("both lists of characters must have the same length"));
        }
        Ok(Value::Text(base.chars().map(|c| from.iter().position(|f| *f == c).map_or(c, |i| to[i])).collect()))
    }),
];

fn text(value: &str) -> Outcome<Value> {
    Ok(Value::Text(value.to_string()))
}

fn characters(a: &Arguments) -> Outcome<Vec<char>> {
    Ok(a.text(0)?.chars().collect())
}

/// Positions `from` (counted from 1) and `count` as a range that lies inside the text.
fn range(from: i64, count: i64, length: usize) -> (usize, usize) {
    let start = (from.max(1) - 1).min(length as i64) as usize;
    let end = start.saturating_add(count.max(0) as usize).min(length);
    (start, end)
}

fn parse_real(text: &str) -> Option<f64> {
    let text = text.trim();
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E'));
    text.parse::<f64>().ok().filter(|x| plain && x.is_finite())
}

fn chr(a: &mut Arguments) -> Outcome<Value> {
    let code = a.integer(0)?;
    match u32::try_from(code).ok().and_then(char::from_u32) {
        Some(c) => Ok(Value::Text(c.to_string())),
        None => Err(a.error(format!("{code} is not the code of a character"))),
    }
}

/// Position of the n-th occurrence, counted without overlap; 0 if there is none.
fn occurrence(a: &Arguments, n: i64) -> Outcome<i64> {
    let (base, part) = (a.text(0)?, a.text(1)?);
    if part.is_empty() || n < 1 {
        return Ok(0);
    }
    let found = base.match_indices(part.as_str()).nth(n as usize - 1);
    Ok(found.map_or(0, |(at, _)| base[..at].chars().count() as i64 + 1))
}

fn case(a: &mut Arguments) -> Outcome<Value> {
    let given = a.text(0)?;
    let capital = |start: bool, c: char| if start { c.to_ascii_uppercase() } else { c.to_ascii_lowercase() };
    Ok(Value::Text(match a.integer(1)? {
        1 => given.to_uppercase(),
        2 => given.to_lowercase(),
        3 => {
            let mut start = true;
            let each = |c: char| {
                let out = capital(start, c);
                start = !c.is_alphanumeric() && c != '\'';
                out
            };
            given.chars().map(each).collect()
        }
        4 => {
            let mut start = true;
            let each = |c: char| {
                let out = capital(start, c);
                start = matches!(c, '.' | '!' | '?') || (start && !c.is_alphanumeric());
                out
            };
            given.chars().map(each).collect()
        }
        other => {
            return Err(
                a.error(format!("the case must be 1 (upper), 2 (lower), 3 (mixed) or 4 (sentence), not {other}"))
            );
        }
    }))
}
