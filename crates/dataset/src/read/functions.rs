//! Expressions of a dataset: the numbers in them that mean objects become those objects.

use std::ops::Range;

use model::{FunctionText, ObjectId, Piece};
use schema::referred;

/// A number in an expression for which there is no object.
#[derive(Debug, PartialEq)]
pub(crate) struct Missing {
    pub statement: &'static str,
    pub number: i64,
    /// Where in the text.
    pub at: Range<usize>,
}

/// Binds the numbers of objects in an expression.
pub(crate) fn bind(
    text: &str,
    mut find: impl FnMut(&'static str, i64) -> Option<ObjectId>,
) -> (FunctionText, Vec<Missing>) {
    let (mut pieces, mut missing) = (Vec::new(), Vec::new());
    // Functions whose parentheses are open, and which argument of them is read.
    let mut open: Vec<(&str, usize)> = Vec::new();
    let (mut done, mut at, mut word) = (0, 0, 0..0);
    let bytes = text.as_bytes();
    let mut leads = false;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'(' => {
                let function = if text[word.end..at].trim().is_empty() { &text[word.clone()] } else { "" };
                open.push((function, 0));
                leads = true;
            }
            b')' => {
                open.pop();
                leads = false;
            }
            b',' => {
                if let Some((_, argument)) = open.last_mut() {
                    *argument += 1;
                }
                leads = true;
            }
            b' ' => {}
            _ if byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.' => {
                let length = text[at..].find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
                word = at..at + length.unwrap_or(text.len() - at);
                let alone = leads && text[word.end..].trim_start().starts_with([',', ')']);
                let wanted = open.last().filter(|_| alone).map(|(function, argument)| referred(function, *argument));
                let kind = wanted.and_then(|statements| statements.first().copied());
                let number = kind.and_then(|_| text[word.clone()].parse::<i64>().ok()).filter(|n| *n > 0);
                if let (Some(statement), Some(number)) = (kind, number) {
                    if let Some(object) = find(statement, number) {
                        if done < word.start {
                            pieces.push(Piece::Text(text[done..word.start].to_string()));
                        }
                        pieces.push(Piece::Object(object));
                        done = word.end;
                    } else {
                        missing.push(Missing { statement, number, at: word.clone() });
                    }
                }
                at = word.end;
                leads = false;
                continue;
            }
            _ => leads = false,
        }
        at += 1;
    }
    if done < text.len() || pieces.is_empty() {
        pieces.push(Piece::Text(text[done..].to_string()));
    }
    (FunctionText { pieces }, missing)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bound(text: &str) -> String {
        let (function, missing) = bind(text, |statement, number| {
            (number < 100)
                .then(|| ObjectId(u32::try_from(number).unwrap() + if statement == "MARKER" { 0 } else { 1000 }))
        });
        assert!(missing.iter().all(|m| text[m.at.clone()].parse() == Ok(m.number)));
        function.write(|id| format!("<{}>", id.0))
    }

    /// Truth: the argument lists of the solver's functions.
    #[test]
    fn numbers_of_objects_are_told_from_other_numbers() {
        for (text, expected) in [
            ("10*STEP(TIME, 0, 0, 1, DX(2, 1,1))", "10*STEP(TIME, 0, 0, 1, DX(<2>, <1>,<1>))"),
            ("BEAM(3,0,2,7) + joint( 4, 1, 6, 0)", "BEAM(<1003>,0,2,<7>) + joint( <1004>, 1, 6, 0)"),
            ("VARVAL(5)*VARVAL (6) - 5", "VARVAL(<1005>)*VARVAL (<1006>) - 5"),
            ("AKISPL(DX(1,2), 0, 8, 1)", "AKISPL(DX(<1>,<2>), 0, <1008>, 1)"),
            ("DX(1+1, 2.0, 2)", "DX(1+1, 2.0, <2>)"),
            ("USER(1, 2)", "USER(1, 2)"),
            ("2*(3)", "2*(3)"),
            ("DX(500)", "DX(500)"),
            ("", ""),
        ] {
            assert_eq!(bound(text), expected);
        }
    }
}
