//! Numbers, lists of them and texts as datasets write them.

use text::{Diagnostic, Span};

/// A number, and whether it is an angle in degrees (`90D`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub value: f64,
    pub degrees: bool,
}

/// Reads `.8`, `4.`, `1.0E-03`, `90D`; a `D` ends a number and is no exponent.
pub(crate) fn parse(text: &str) -> Option<Number> {
    let text = text.trim();
    let (digits, degrees) = match text.strip_suffix(['d', 'D']) {
        Some(digits) => (digits, true),
        None => (text, false),
    };
    // Old programs leave a blank behind the sign.
    let (sign, digits) = match digits.strip_prefix('-') {
        Some(rest) => (-1.0, rest.trim_start()),
        None => (1.0, digits.strip_prefix('+').map_or(digits, str::trim_start)),
    };
    let plain = digits.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
    if !plain || !digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    let value = digits.parse::<f64>().ok().filter(|x| x.is_finite())?;
    Some(Number { value: sign * value, degrees })
}

/// Why a text is no number.
pub(crate) fn no_number(text: &str, keyword: &str, at: Span) -> Diagnostic {
    let shown: String = text.chars().take(40).collect();
    let wrong = Diagnostic::error("dataset/number", format!("`{keyword}` needs a number, not `{shown}`"))
        .at(at, "a number was expected");
    if let Some(list) = list_of(text, |item| parse(item).is_some()) {
        return wrong.fix(format!("part them by commas: `{list}`"), at, list);
    }
    if is_word(text) {
        return wrong.help(format!("an argument of its own is written `{text} = ...`"));
    }
    let fortran = text
        .split_once(['d', 'D'])
        .filter(|(_, exponent)| exponent.trim_start_matches(['+', '-']).parse::<u32>().is_ok());
    match fortran.filter(|(mantissa, _)| parse(mantissa).is_some()) {
        Some((mantissa, exponent)) => {
            let number = format!("{mantissa}E{exponent}");
            wrong.note("`D` behind a number means degrees").fix(format!("write `{number}`"), at, number)
        }
        None => wrong,
    }
}

/// What stands there with blanks between, with commas, if that makes it a list.
pub(crate) fn list_of(text: &str, fits: impl Fn(&str) -> bool) -> Option<String> {
    let items: Vec<_> = text.split_whitespace().collect();
    (items.len() > 1 && items.iter().all(|item| fits(item))).then(|| items.join(", "))
}

/// Whether a text may be the name of an argument.
pub(crate) fn is_word(text: &str) -> bool {
    text.len() > 1 && text.bytes().all(|b| b.is_ascii_alphabetic() || b == b'_')
}

/// A text without its quotes.
pub(crate) fn unquoted(text: &str) -> &str {
    let text = text.trim();
    text.strip_prefix('"').and_then(|t| t.strip_suffix('"')).filter(|t| !t.contains('"')).unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: forms seen in public datasets.
    #[test]
    fn numbers_of_datasets() {
        for (text, value, degrees) in [
            (".8", 0.8, false),
            ("4.", 4.0, false),
            ("1.0E-03", 1e-3, false),
            ("1E7", 1e7, false),
            ("2.E-4", 2e-4, false),
            ("1.387778781E-014", 1.387_778_781e-14, false),
            ("90D", 90.0, true),
            ("-30.0d", -30.0, true),
            ("1.9E+05", 1.9e5, false),
            ("- 2", -2.0, false),
        ] {
            assert_eq!(parse(text), Some(Number { value, degrees }), "{text}");
        }
        for text in ["", "-", ".", "1D3", "1e", "nan", "inf", "1.2.3", "0x10", "1e999", "é"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
