//! Statements: a pull parser that holds one statement at a time, whatever the size of the file.
//!
//! A statement is recognised without knowing any command: keywords until the first `word =`, then
//! `name = value, value` pairs. A word behind a complete value begins the next pair if `=` follows.

use text::{Diagnostic, FileId, Span};

use super::cursor::{Closing, Cursor, Gap};
use super::expression::ExpressionParser;
use super::tree::{Argument, Expression, Item, ItemKind, Items, Statement, StatementKind};
use super::troubles::{
    expression_without_parentheses, joined, misplaced, missing_keyword, missing_value, out_of_range, stray_text,
    unclosed_parenthesis, unclosed_quote,
};
use crate::number::{end_of_number, value_of};
use crate::quoted::{end_of_value_string, unescape};

/// Room made at once for the arguments of a command, and for the values of an argument that has several:
/// a place is three numbers.
const USUAL_ARGUMENTS: usize = 8;
const USUAL_LIST: usize = 4;

/// Reads a command file statement by statement.
#[derive(Debug)]
pub struct Parser<'a> {
    file: FileId,
    cursor: Cursor<'a>,
    diagnostics: Vec<Diagnostic>,
    /// Offset behind the last token of the statement.
    last_end: usize,
    /// One note about a missing `&` is enough for a statement.
    told_about_joining: bool,
    /// Where the last statement ended, if it was a command that may go on.
    above: Option<usize>,
}

/// All statements of a text, and all its troubles.
pub fn parse(file: FileId, text: &str) -> (Vec<Statement>, Vec<Diagnostic>) {
    let mut parser = Parser::new(file, text);
    let (mut statements, mut all) = (Vec::new(), Vec::new());
    while let Some((statement, diagnostics)) = parser.next_statement() {
        statements.push(statement);
        all.extend(diagnostics);
    }
    (statements, all)
}

/// A text that is known to be one expression (or a bare tuple), with or without parentheses
/// around it. `offset` is where the text begins in the file.
pub fn parse_expression(file: FileId, text: &str, offset: usize) -> (Expression, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let tree = ExpressionParser::new(file, text, 0..text.len(), offset, &mut diagnostics).whole();
    (tree, diagnostics)
}

impl<'a> Parser<'a> {
    pub fn new(file: FileId, text: &'a str) -> Self {
        Parser {
            file,
            cursor: Cursor::new(text),
            diagnostics: Vec::new(),
            last_end: 0,
            told_about_joining: false,
            above: None,
        }
    }

    /// Byte offset up to which the text has been read.
    pub fn offset(&self) -> usize {
        self.cursor.pos
    }

    /// The next statement with its troubles, or none at the end of the file. A statement whose
    /// troubles contain an error has been understood only in part.
    pub fn next_statement(&mut self) -> Option<(Statement, Vec<Diagnostic>)> {
        if !self.cursor.begin_statement() {
            return None;
        }
        let start = self.cursor.pos;
        self.last_end = start;
        self.told_about_joining = false;
        let kind = self.statement();
        self.cursor.skip_statement();
        self.above = self.may_go_on(&kind).then_some(self.last_end);
        let statement = Statement { span: self.span(start, self.last_end), kind };
        Some((statement, std::mem::take(&mut self.diagnostics)))
    }

    /// Whether a forgotten `&` behind a statement is likely: it is a command, and understood so far.
    fn may_go_on(&self, kind: &StatementKind) -> bool {
        let StatementKind::Command { keywords, arguments } = kind else { return false };
        (keywords.len() > 1 || !arguments.is_empty())
            && self.diagnostics.iter().all(|d| !d.is_error() || d.code == "syntax/missing-keyword")
    }

    fn statement(&mut self) -> StatementKind {
        let mut keywords = Vec::new();
        while self.cursor.skip_gap() == Gap::Token {
            let start = self.cursor.pos;
            let Some(word) = self.word() else {
                if keywords.is_empty() {
                    self.last_end = self.last_end.max(self.cursor.line_end(start).min(self.cursor.unclosed_end(start)));
                    return StatementKind::Broken;
                }
                break;
            };
            if self.cursor.skip_gap() != Gap::Token || self.cursor.peek() != Some(b'=') {
                keywords.push(word);
                continue;
            }
            if keywords.is_empty() {
                let text = self.slice(word);
                if text.contains('.') {
                    let values = self.values_behind_equals(word);
                    self.trailing();
                    return StatementKind::Assignment { target: word, values };
                }
                let above = self.above.filter(|end| {
                    let between = &self.cursor.text[*end..start];
                    between.matches('\n').count() == 1 && !between.contains('&')
                });
                let above = above.map(|end| self.span(end, end));
                self.diagnostics.push(missing_keyword(word, text, above));
            }
            let arguments = self.arguments(word);
            return StatementKind::Command { keywords, arguments };
        }
        StatementKind::Command { keywords, arguments: Vec::new() }
    }

    /// `name = values` pairs to the end of the statement; the cursor is at the first `=`.
    fn arguments(&mut self, first: Span) -> Vec<Argument> {
        let mut arguments = Vec::with_capacity(USUAL_ARGUMENTS);
        let mut name = first;
        loop {
            let at = self.cursor.pos + 1;
            let values = self.values_behind_equals(name);
            let value_span = match (values.first(), values.last()) {
                (Some(first), Some(last)) => first.span.to(last.span),
                _ => self.span(at, at),
            };
            arguments.push(Argument { name, values, value_span });
            match self.next_name() {
                Some(next) => name = next,
                None => return arguments,
            }
        }
    }

    /// The word before the next `=`; what stands between is reported and left out.
    fn next_name(&mut self) -> Option<Span> {
        let mut stray: Option<Span> = None;
        let name = loop {
            if self.cursor.skip_gap() != Gap::Token {
                break None;
            }
            let Some(word) = self.stray_or_word() else { break None };
            if self.cursor.skip_gap() == Gap::Token && self.cursor.peek() == Some(b'=') {
                break Some(word);
            }
            stray = Some(stray.map_or(word, |s| s.to(word)));
        };
        if let Some(span) = stray {
            self.diagnostics.push(stray_text(span, self.slice(span)));
        }
        name
    }

    /// Reports what follows the values of an assignment.
    fn trailing(&mut self) {
        if self.cursor.skip_gap() == Gap::Token {
            let start = self.cursor.pos;
            self.cursor.skip_statement();
            let end = self.cursor.line_end(start).min(self.cursor.unclosed_end(start));
            self.last_end = end;
            let span = self.span(start, end);
            self.diagnostics.push(stray_text(span, self.slice(span)));
        }
    }

    /// The list of values; the cursor is at the `=`.
    fn values_behind_equals(&mut self, name: Span) -> Items {
        let equals = self.cursor.pos;
        self.cursor.pos += 1;
        self.last_end = self.cursor.pos;
        let mut values = Items::new();
        let mut gap = self.cursor.skip_gap();
        if gap == Gap::EndOfLine && self.cursor.join_next_line() {
            gap = Gap::Token;
            if !self.told_about_joining {
                self.told_about_joining = true;
                self.diagnostics.push(joined(self.span(equals, equals + 1)));
            }
        }
        loop {
            if gap != Gap::Token {
                self.missing_value(name, !values.is_empty());
                return values;
            }
            let start = self.cursor.pos;
            let (last_end, diagnostics_before) = (self.last_end, self.diagnostics.len());
            let Some(item) = self.item() else {
                if self.diagnostics.len() == diagnostics_before {
                    self.missing_value(name, !values.is_empty());
                }
                if self.cursor.pos == start && self.cursor.peek() == Some(b',') {
                    self.cursor.pos += 1; // `a = , 2` and `1,,2`: the gap is reported, the rest is read
                    gap = self.cursor.skip_gap();
                    continue;
                }
                return values;
            };
            let end = self.cursor.pos;
            gap = self.cursor.skip_gap();
            if gap == Gap::Token && self.cursor.peek() == Some(b'=') && matches!(item.kind, ItemKind::Word) {
                // `length = ixx = 4`: the word is the next name, and the value was forgotten.
                self.cursor.pos = start;
                self.last_end = last_end;
                self.diagnostics.truncate(diagnostics_before);
                self.missing_value(name, !values.is_empty());
                return values;
            }
            self.last_end = end;
            if values.len() == 1 {
                values.reserve(USUAL_LIST - 1);
            }
            values.push(item);
            if gap != Gap::Token || self.cursor.peek() != Some(b',') {
                return values;
            }
            self.cursor.pos += 1;
            self.last_end = self.cursor.pos;
            gap = self.cursor.skip_gap();
        }
    }

    fn missing_value(&mut self, name: Span, behind_comma: bool) {
        let text = self.slice(name);
        let span = self.span(self.last_end - 1, self.last_end);
        let at_line_end = self.cursor.end.is_some();
        self.diagnostics.push(missing_value(span, text, behind_comma, at_line_end));
    }

    /// One value; none if no value begins here.
    fn item(&mut self) -> Option<Item> {
        let start = self.cursor.pos;
        match self.cursor.peek()? {
            b'(' => self.parenthesised(start),
            b'"' | b'\'' => self.string(start),
            b'=' | b',' => None,
            _ => {
                let word = self.word()?;
                Some(self.number_or_word(word))
            }
        }
    }

    fn parenthesised(&mut self, start: usize) -> Option<Item> {
        match self.cursor.closing(start) {
            Closing::At(close) => {
                self.cursor.pos = close + 1;
                let inside = start + 1..close;
                let tree = ExpressionParser::new(self.file, self.cursor.text, inside, 0, &mut self.diagnostics).whole();
                Some(Item { span: self.span(start, close + 1), kind: ItemKind::Expression(Box::new(tree)) })
            }
            Closing::Missing => self.unclosed(start, unclosed_parenthesis(self.span(start, start + 1))),
            Closing::QuoteOpen(quote) => {
                self.unclosed(start, unclosed_quote(self.span(quote, quote + 1), self.escaped_quote_behind(quote)))
            }
        }
    }

    fn string(&mut self, start: usize) -> Option<Item> {
        let Some(end) = end_of_value_string(self.cursor.bytes, start) else {
            return self.unclosed(start, unclosed_quote(self.span(start, start + 1), self.escaped_quote_behind(start)));
        };
        if self.cursor.bytes.get(end) == Some(&b'.') {
            // A partial path that begins with an odd name: "odd name".marker_1
            let word = self.word()?;
            return Some(Item { span: word, kind: ItemKind::Word });
        }
        self.cursor.pos = end;
        let text = unescape(&self.cursor.text[start..end]);
        Some(Item { span: self.span(start, end), kind: ItemKind::Text(text) })
    }

    /// Reports something that the line never closes and gives up the rest of the statement, which
    /// cannot be told from the inside of the string or expression.
    fn unclosed(&mut self, start: usize, diagnostic: Diagnostic) -> Option<Item> {
        self.diagnostics.push(diagnostic);
        self.last_end = self.cursor.unclosed_end(start);
        self.cursor.pos = self.last_end;
        self.cursor.skip_statement();
        None
    }

    fn escaped_quote_behind(&self, quote: usize) -> bool {
        let rest = &self.cursor.text[quote + 1..self.cursor.unclosed_end(quote)];
        rest.rfind(char::from(self.cursor.bytes[quote])).is_some_and(|at| rest[..at].ends_with('\\'))
    }

    /// A word, reporting what cannot be one.
    fn word(&mut self) -> Option<Span> {
        let start = self.cursor.pos;
        match self.cursor.end_of_word() {
            Err(quote) => {
                self.unclosed(start, unclosed_quote(self.span(quote, quote + 1), self.escaped_quote_behind(quote)));
                None
            }
            Ok(end) if end == start => {
                let length = self.cursor.text[start..].chars().next().map_or(0, char::len_utf8);
                self.misplaced(start, start + length);
                None
            }
            Ok(end) if self.cursor.bytes.get(end) == Some(&b'(') => self.bare_call(start, end),
            Ok(end) => {
                self.cursor.pos = end;
                self.last_end = end;
                Some(self.span(start, end))
            }
        }
    }

    /// `name(...)` outside parentheses: a number with a compound unit is one value, a call is not.
    fn bare_call(&mut self, start: usize, open: usize) -> Option<Span> {
        let close = match self.cursor.closing(open) {
            Closing::At(close) => close + 1,
            Closing::Missing => {
                self.unclosed(start, unclosed_parenthesis(self.span(open, open + 1)));
                return None;
            }
            Closing::QuoteOpen(quote) => {
                self.unclosed(start, unclosed_quote(self.span(quote, quote + 1), self.escaped_quote_behind(quote)));
                return None;
            }
        };
        let span = self.span(start, close);
        self.cursor.pos = close;
        self.last_end = close;
        if unsigned_number_end(self.cursor.bytes, start) != Some(open) {
            self.diagnostics.push(expression_without_parentheses(span, self.slice(span)));
        }
        Some(span)
    }

    fn misplaced(&mut self, start: usize, end: usize) {
        let span = self.span(start, end);
        let found = self.slice(span);
        self.diagnostics.push(misplaced(span, found));
        self.last_end = end;
        self.cursor.pos = end;
        self.cursor.skip_statement();
    }

    /// Between two arguments: a word, or a value that belongs to no argument.
    fn stray_or_word(&mut self) -> Option<Span> {
        let start = self.cursor.pos;
        let span = match self.cursor.peek()? {
            b'(' | b'"' | b'\'' => self.item()?.span,
            b'=' | b',' | b')' => {
                self.cursor.pos += 1;
                self.span(start, start + 1)
            }
            _ => self.word()?,
        };
        self.last_end = self.cursor.pos;
        Some(span)
    }

    fn number_or_word(&mut self, word: Span) -> Item {
        let text = self.slice(word);
        let Some(end) = unsigned_number_end(text.as_bytes(), 0) else {
            return Item { span: word, kind: ItemKind::Word };
        };
        let unit = &text[end..];
        let unit = match unit.strip_prefix('(').and_then(|u| u.strip_suffix(')')) {
            Some(compound) => compound.trim(),
            None if unit.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') => unit,
            None => return Item { span: word, kind: ItemKind::Word },
        };
        let value = value_of(&text[..end]);
        if value.is_infinite() {
            let span = Span { end: word.start + end as u32, ..word };
            self.diagnostics.push(out_of_range(span, &text[..end]));
        }
        let unit = (!unit.is_empty()).then(|| unit.into());
        Item { span: word, kind: ItemKind::Number { value, unit } }
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, start, end)
    }

    fn slice(&self, span: Span) -> &'a str {
        &self.cursor.text[span.range()]
    }
}

/// Offset behind a number that may have a sign.
fn unsigned_number_end(bytes: &[u8], at: usize) -> Option<usize> {
    let sign = usize::from(matches!(bytes.get(at), Some(b'-' | b'+')));
    end_of_number(bytes, at + sign)
}
