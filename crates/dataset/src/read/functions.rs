//! Expressions of a dataset: the numbers in them that mean objects become those objects.

use std::ops::Range;

use model::{FunctionText, ObjectId, Piece};
use schema::referred;
use syntax::function::Calls;

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
    let mut calls = Calls::default();
    let (mut done, mut at) = (0, 0);
    let part_of_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    while let Some(before) = text[at..].find(part_of_word) {
        let begin = at + before;
        let length = text[begin..].find(|c| !part_of_word(c)).unwrap_or(text.len() - begin);
        let word = begin..begin + length;
        calls.read(&text[at..begin]);
        at = word.end;
        // A number that is an argument by itself.
        let alone =
            text[..begin].trim_end().ends_with(['(', ',']) && text[word.end..].trim_start().starts_with([',', ')']);
        let wanted = calls.place().filter(|_| alone).map(|(function, argument)| referred(function, argument));
        let number = text[word.clone()].parse::<i64>().ok().filter(|n| *n > 0);
        let kind = wanted.and_then(|statements| statements.first().copied());
        let object = number.zip(kind).map(|(number, statement)| (find(statement, number), number, statement));
        match object {
            Some((Some(object), ..)) => {
                if done < word.start {
                    pieces.push(Piece::Text(text[done..word.start].to_string()));
                }
                pieces.push(Piece::Object(object));
                calls.read_object();
                done = word.end;
                continue;
            }
            Some((None, number, statement)) => missing.push(Missing { statement, number, at: word.clone() }),
            None => {}
        }
        calls.read(&text[word]);
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
            ("DX(\t1,\t2 )", "DX(\t<1>,\t<2> )"),
            ("DX 2 (1)", "DX 2 (1)"),
            ("DX(500)", "DX(500)"),
            ("", ""),
        ] {
            assert_eq!(bound(text), expected);
        }
    }
}
