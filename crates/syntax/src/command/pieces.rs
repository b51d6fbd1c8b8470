//! A statement as its tokens and the comments between them: what a formatter arranges anew, and
//! what it compares to be sure that the arrangement has changed no more than blanks.

use text::{FileId, Span};

use super::cursor::{is_blank, line_end};
use super::{Argument, Item, Parser, Statement, StatementKind};

/// What stands between two tokens, separators and continuation marks left out.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Gap<'a> {
    pub comments: Vec<Remark<'a>>,
    /// The line ends in it.
    pub broken: bool,
}

#[derive(Debug, PartialEq, Eq)]
pub(super) struct Remark<'a> {
    pub text: &'a str,
    /// It has a line of its own.
    pub own_line: bool,
}

/// A statement with its place in the file.
#[derive(Debug)]
pub(super) struct Placed {
    pub statement: Statement,
    /// Where the next line begins.
    pub end: usize,
    /// It was not understood, and must stay as it is.
    pub fixed: bool,
    pub diagnostics: Vec<text::Diagnostic>,
}

/// The statements of a text in order.
pub(super) struct Statements<'a> {
    text: &'a str,
    parser: Parser<'a>,
}

impl<'a> Statements<'a> {
    pub fn of(file: FileId, text: &'a str) -> Statements<'a> {
        Statements { text, parser: Parser::new(file, text) }
    }
}

impl Iterator for Statements<'_> {
    type Item = Placed;

    fn next(&mut self) -> Option<Placed> {
        let (statement, diagnostics) = self.parser.next_statement()?;
        let end = self.parser.offset();
        let fixed = diagnostics.iter().any(text::Diagnostic::is_error)
            || statement.kind == StatementKind::Broken
            || tokens(&statement).iter().any(|t| declares_a_parameter(&self.text[t.range()]))
            || gaps(self.text, &statement, end).is_none();
        Some(Placed { statement, end, fixed, diagnostics })
    }
}

/// Whether a word holds `$name:t=...` of a macro, which ends at the next blank and nowhere else.
fn declares_a_parameter(word: &str) -> bool {
    word.match_indices('$').any(|(at, _)| {
        let rest = word[at + 1..].trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
        rest.starts_with(':')
    })
}

/// The tokens of a statement in order: keywords, names, values.
pub(super) fn tokens(statement: &Statement) -> Vec<Span> {
    let values = |found: &mut Vec<Span>, values: &[Item]| found.extend(values.iter().map(|v| v.span));
    let mut found = Vec::new();
    match &statement.kind {
        StatementKind::Command { keywords, arguments } => {
            found.extend(keywords);
            for Argument { name, values: of_it, .. } in arguments {
                found.push(*name);
                values(&mut found, of_it);
            }
        }
        StatementKind::Assignment { target, values: of_it } => {
            found.push(*target);
            values(&mut found, of_it);
        }
        StatementKind::Broken => {}
    }
    found
}

/// What follows each token up to the next one; the last entry reaches to the end of the statement.
/// None if something else than layout stands there.
pub(super) fn gaps<'a>(text: &'a str, statement: &Statement, end: usize) -> Option<Vec<Gap<'a>>> {
    let tokens = tokens(statement);
    let next = tokens.iter().skip(1).map(|t| t.start as usize).chain(std::iter::once(end));
    tokens.iter().zip(next).map(|(token, next)| gap(text.get(token.end as usize..next)?)).collect()
}

fn gap(text: &str) -> Option<Gap<'_>> {
    let bytes = text.as_bytes();
    let mut gap = Gap::default();
    let mut at = 0;
    while let Some(&b) = bytes.get(at) {
        match b {
            b'\n' => {
                gap.broken = true;
                at += 1;
            }
            b'!' => {
                let end = line_end(bytes, at);
                gap.comments.push(Remark { text: text[at..end].trim_end_matches(blank), own_line: gap.broken });
                at = end;
            }
            b'=' | b',' | b'&' => at += 1,
            b if is_blank(b) => at += 1,
            _ => return None,
        }
    }
    Some(gap)
}

/// A blank as the grammar knows it.
pub(super) fn blank(c: char) -> bool {
    u8::try_from(c).is_ok_and(|b| b.is_ascii() && is_blank(b))
}

/// Whether two texts hold the same tokens and the same comments in the same order.
pub(super) fn same_but_for_layout(file: FileId, a: &str, b: &str) -> bool {
    let (mut left, mut right) = (Outline::of(file, a), Outline::of(file, b));
    loop {
        match (left.next(), right.next()) {
            (None, None) => return true,
            (x, y) if x == y => {}
            _ => return false,
        }
    }
}

/// A statement and the comments and marks before it.
#[derive(Debug, PartialEq, Eq)]
struct Entry<'a> {
    before: Vec<&'a str>,
    tokens: Vec<&'a str>,
    comments: Vec<&'a str>,
    fixed: bool,
}

struct Outline<'a> {
    text: &'a str,
    statements: Statements<'a>,
    at: usize,
    /// Comments that ended the statement before: whether they belong to it is layout.
    carried: Vec<&'a str>,
    done: bool,
}

impl<'a> Outline<'a> {
    fn of(file: FileId, text: &'a str) -> Outline<'a> {
        let at = if text.starts_with('\u{feff}') { 3 } else { 0 };
        Outline { text, statements: Statements::of(file, text), at, carried: Vec::new(), done: false }
    }
}

impl<'a> Iterator for Outline<'a> {
    type Item = Entry<'a>;

    fn next(&mut self) -> Option<Entry<'a>> {
        if self.done {
            return None;
        }
        let text = self.text;
        let lines = |from: usize, to: usize| text[from..to].split('\n').map(|l| l.trim_matches(blank));
        let mut before = std::mem::take(&mut self.carried);
        let Some(placed) = self.statements.next() else {
            self.done = true;
            before.extend(lines(self.at, text.len()).filter(|l| !l.is_empty()));
            return Some(Entry { before, tokens: Vec::new(), comments: Vec::new(), fixed: false });
        };
        let start = placed.statement.span.start as usize;
        before.extend(lines(self.at, start).filter(|l| !l.is_empty()));
        self.at = placed.end;
        let mut comments = Vec::new();
        let tokens = if placed.fixed {
            vec![text[start..placed.end].trim_end_matches(|c| blank(c) || c == '\n')]
        } else {
            let mut found = gaps(text, &placed.statement, placed.end).unwrap_or_default();
            let last = found.pop().unwrap_or_default();
            comments.extend(found.iter().flat_map(|g| &g.comments).map(|c| c.text));
            self.carried.extend(last.comments.iter().map(|c| c.text));
            tokens(&placed.statement).iter().map(|t| &text[t.range()]).collect()
        };
        Some(Entry { before, tokens, comments, fixed: placed.fixed })
    }
}
