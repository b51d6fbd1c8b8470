//! Quoted strings: where they end and what they mean. A backslash before the string's own quote or
//! before a backslash takes its meaning away; before anything else it stands for itself, as in
//! `"C:\models\car.cmd"`.

/// Byte offset behind the closing quote of the string that opens at `at`; none if `end` or the end
/// of the line comes first.
pub(crate) fn end_of_string(bytes: &[u8], at: usize, end: usize) -> Option<usize> {
    let quote = bytes[at];
    let mut i = at + 1;
    while i < end {
        match bytes[i] {
            b'\\' if i + 1 < end && (bytes[i + 1] == quote || bytes[i + 1] == b'\\') => i += 2,
            b if b == quote => return Some(i + 1),
            b'\n' => return None,
            _ => i += 1,
        }
    }
    None
}

/// Like [`end_of_string`] for a value, which may go on over several lines: exports write solver
/// commands so. A quote on a later line closes it only if it looks like the end of a value and not
/// like the beginning of the next one; otherwise a forgotten quote would swallow half a file.
pub(crate) fn end_of_value_string(bytes: &[u8], at: usize) -> Option<usize> {
    if let Some(end) = end_of_string(bytes, at, bytes.len()) {
        return Some(end);
    }
    let quote = bytes[at];
    let mut i = at + 1;
    let close = loop {
        match *bytes.get(i)? {
            b'\\' if bytes.get(i + 1).is_some_and(|b| *b == quote || *b == b'\\') => i += 2,
            b if b == quote => break i,
            _ => i += 1,
        }
    };
    let is_dark = |b: &&u8| !matches!(**b, b' ' | b'\t' | b'\r');
    let before = bytes[at + 1..close].iter().rev().find(is_dark);
    let behind = bytes[close + 1..].iter().find(is_dark);
    let ends_a_value = matches!(behind, None | Some(b'\n' | b'&' | b',' | b'!'));
    (ends_a_value && !matches!(before, Some(b'=' | b',' | b'('))).then_some(close + 1)
}

/// The meaning of a string, given with its two quotes.
pub(crate) fn unescape(quoted: &str) -> String {
    let quote = if quoted.starts_with('\'') { '\'' } else { '"' };
    let inside = quoted.get(1..quoted.len().saturating_sub(1)).unwrap_or_default();
    if !inside.contains('\\') {
        return inside.to_owned();
    }
    let mut meaning = String::with_capacity(inside.len());
    let mut chars = inside.chars().peekable();
    while let Some(c) = chars.next() {
        match (c, chars.peek()) {
            ('\\', Some(&next)) if next == quote || next == '\\' => {
                meaning.push(next);
                chars.next();
            }
            _ => meaning.push(c),
        }
    }
    meaning
}

/// The double-quoted string that means `text`, for whoever writes command files.
pub fn quote(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_path_keeps_its_backslashes() {
        assert_eq!(unescape(r#""C:\models\car.cmd""#), r"C:\models\car.cmd");
        assert_eq!(unescape(r#""a \"b\" \\ \'c""#), r#"a "b" \ \'c"#);
    }

    #[test]
    fn a_value_may_span_lines_but_a_forgotten_quote_does_not() {
        let text = b"\"a\nb\nc\" &\n";
        assert_eq!(end_of_value_string(text, 0), Some(7));
        assert_eq!(end_of_value_string(b"\"a\nb\n\"\n", 0), Some(6));
        assert_eq!(end_of_value_string(b"\"a &\nb = \"c\"\n", 0), None);
        assert_eq!(end_of_value_string(b"\"a, &\n\"b\", \"c\"\n", 0), None);
        assert_eq!(end_of_value_string(b"\"a\n\n", 0), None);
    }

    proptest! {
        #[test]
        fn a_quoted_text_is_read_back(text in "[^\r\n]*") {
            let quoted = quote(&text);
            prop_assert_eq!(end_of_string(quoted.as_bytes(), 0, quoted.len()), Some(quoted.len()));
            prop_assert_eq!(unescape(&quoted), text);
        }
    }
}
