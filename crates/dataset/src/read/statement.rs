//! A statement and its arguments, with the places they stand in.

use std::ops::Range;

use smallvec::SmallVec;
use text::{FileId, Span};

use super::{values, vocabulary::Form};

/// One argument of a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// In full and in capitals; as written where the statement does not know it.
    pub keyword: String,
    pub(crate) form: Form,
    /// Whether the statement knows the keyword.
    pub known: bool,
    /// Where the value stands in the source, line by line.
    pub(crate) parts: SmallVec<[Range<usize>; 1]>,
    pub span: Span,
    pub keyword_span: Span,
}

impl Argument {
    /// The value as one text. Lines of an expression are joined without anything between them but what
    /// is there, other values with commas.
    pub fn value(&self, source: &str) -> String {
        match self.parts.as_slice() {
            [only] => source.get(only.clone()).unwrap_or_default().trim().to_string(),
            parts => {
                let texts = parts.iter().filter_map(|part| source.get(part.clone()));
                let (comma, texts) = match self.form {
                    Form::Function => ("", texts.collect::<Vec<_>>()),
                    _ => (", ", texts.map(str::trim).filter(|text| !text.is_empty()).collect()),
                };
                texts.join(comma).trim().to_string()
            }
        }
    }

    /// Where the value stands, from its first line to its last.
    pub(crate) fn value_span(&self, file: FileId) -> Span {
        match (self.parts.first(), self.parts.last()) {
            (Some(first), Some(last)) => Span::new(file, first.start, last.end),
            _ => self.span,
        }
    }

    /// Where in the source a place in the value of an expression is.
    pub(crate) fn source_of(&self, source: &str, mut offset: usize) -> usize {
        for (index, part) in self.parts.iter().enumerate() {
            let text = source.get(part.clone()).unwrap_or_default();
            let skipped = if index == 0 { text.len() - text.trim_start().len() } else { 0 };
            let length = text.len() - skipped;
            if offset < length {
                return part.start + skipped + offset;
            }
            offset -= length;
        }
        self.span.range().start
    }

    /// The values between commas, with their places; an empty one behind a last comma does not count.
    pub(crate) fn items<'s>(&self, source: &'s str) -> Vec<(&'s str, Range<usize>)> {
        let mut items = Vec::new();
        for part in &self.parts {
            let Some(text) = source.get(part.clone()) else { continue };
            let mut at = 0;
            while at <= text.len() {
                let end = at + item_length(&text[at..]);
                let item = text[at..end].trim();
                if !item.is_empty() {
                    let begin = part.start + at + text[at..end].len() - text[at..end].trim_start().len();
                    items.push((item, begin..begin + item.len()));
                }
                at = end + 1;
            }
        }
        items
    }

    /// The words between commas or colons, with their places and without their quotes.
    pub(crate) fn words<'s>(&self, source: &'s str) -> Vec<(&'s str, Range<usize>)> {
        let mut words = Vec::new();
        for (item, range) in self.items(source) {
            let (mut at, mut in_quotes) = (range.start, false);
            let parts = item.split(|c: char| {
                in_quotes ^= c == '"';
                c == ':' && !in_quotes
            });
            for part in parts {
                let word = values::unquoted(part);
                let begin = at + part.find(word).unwrap_or(0);
                words.push((word, begin..begin + word.len()));
                at += part.len() + 1;
            }
        }
        words
    }
}

/// One statement: `MARKER/0201, PART = 2, QP = 0, 6, 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// In full and in capitals.
    pub name: &'static str,
    pub id: Option<i64>,
    pub arguments: Vec<Argument>,
    /// Comments in it and before it, without the mark and the blank behind that.
    pub comments: Vec<String>,
    /// Of the name of the object, from the comment `adams_view_name='...'`.
    pub view_name: Option<String>,
    pub(crate) view_units: Option<String>,
    /// It stands behind comment marks: the object is switched off.
    pub inactive: bool,
    pub span: Span,
    /// Name and number.
    pub head: Span,
}

impl Statement {
    /// An argument by its full keyword; the last one counts.
    pub fn argument(&self, keyword: &str) -> Option<&Argument> {
        self.arguments.iter().rev().find(|a| a.keyword.eq_ignore_ascii_case(keyword))
    }

    /// The value of an argument by its full keyword.
    pub fn value(&self, keyword: &str, source: &str) -> Option<String> {
        self.argument(keyword).filter(|a| a.form != Form::Flag).map(|a| a.value(source))
    }

    /// Whether a bare word is among the arguments.
    pub fn has(&self, word: &str) -> bool {
        self.arguments.iter().any(|a| a.form == Form::Flag && a.keyword.eq_ignore_ascii_case(word))
    }
}

/// Bytes up to the next comma outside parentheses and quotes.
pub(super) fn item_length(text: &str) -> usize {
    let (mut depth, mut in_quotes) = (0usize, false);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => in_quotes = !in_quotes,
            b'(' if !in_quotes => depth += 1,
            b')' if !in_quotes => depth = depth.saturating_sub(1),
            b',' if !in_quotes && depth == 0 => return at,
            _ => {}
        }
    }
    text.len()
}
