//! Plain numbers, as every grammar writes them: `8`, `2.5`, `.05`, `5.`, `1.0E-002`. A letter `d`
//! is never an exponent; it is left for the caller, to whom it means degrees.

/// Byte offset behind the unsigned number that starts at `at`; none if there is no number.
pub(crate) fn end_of_number(bytes: &[u8], at: usize) -> Option<usize> {
    let digits_from = |mut i: usize| {
        while bytes.get(i).is_some_and(u8::is_ascii_digit) {
            i += 1;
        }
        i
    };
    let whole = digits_from(at);
    let mut end = whole;
    if bytes.get(whole) == Some(&b'.') {
        end = digits_from(whole + 1);
        if whole == at && end == whole + 1 {
            return None; // a lone point
        }
    } else if whole == at {
        return None;
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits_from(end + 1 + sign);
        if exponent > end + 1 + sign {
            end = exponent; // otherwise the `e` begins a unit
        }
    }
    Some(end)
}

/// The value of a text that [`end_of_number`] delimited, possibly with a sign before it. Infinite
/// where the number is too large.
pub(crate) fn value_of(text: &str) -> f64 {
    // Small integers are the most frequent numbers by far.
    let bytes = text.as_bytes();
    if bytes.len() <= 8 && bytes.iter().all(u8::is_ascii_digit) {
        return f64::from(bytes.iter().fold(0_u32, |sum, b| sum * 10 + u32::from(b - b'0')));
    }
    debug_assert!(text.parse::<f64>().is_ok(), "`{text}` was delimited as a number");
    text.parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_number_ends_where_it_should() {
        for (text, length) in [
            ("8", 1),
            ("5.", 2),
            (".05,", 3),
            ("1.0E-002 ", 8),
            ("2.07e+11", 8),
            ("90d", 2),
            ("6.0E-06d", 7),
            ("3e", 1),
            ("3e+", 1),
            ("6inch", 1),
        ] {
            assert_eq!(end_of_number(text.as_bytes(), 0), Some(length), "{text}");
        }
        for text in [".", "", "x", ".m", "-1", "e5"] {
            assert_eq!(end_of_number(text.as_bytes(), 0), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn what_rust_prints_is_read_back_exactly(x in proptest::num::f64::POSITIVE | proptest::num::f64::ZERO) {
            for text in [format!("{x}"), format!("{x:e}"), format!("{x:E}")] {
                prop_assert_eq!(end_of_number(text.as_bytes(), 0), Some(text.len()));
                prop_assert_eq!(value_of(&text).to_bits(), x.to_bits());
            }
        }
    }
}
