//! Expressions of the command language: precedence climbing over the bytes of one line.
//!
//! An expression either is understood or is one [`ExpressionKind::Broken`] with one diagnostic.
//! Every function returns the height of its tree beside the tree, so that no input makes a tree too
//! high to walk or drop.

use text::{Diagnostic, FileId, Span};

use super::cursor::{self, Closing, is_blank, is_control, is_name};
use super::tree::{BinaryOperator, Expression, ExpressionKind, RANGE, UnaryOperator};
use super::troubles::{out_of_range, unclosed_parenthesis, unclosed_quote, unexpected_character};
use crate::number::{end_of_number, value_of};
use crate::quoted::{end_of_string, unescape};
use crate::{MAX_HEIGHT, MAX_NESTING};

/// The diagnostic has been pushed; the expression is given up.
pub(super) struct GivenUp;

type Tree = Result<(Expression, u32), GivenUp>;
type Trees = Result<(Vec<Expression>, u32), GivenUp>;

/// Binding strength of the loosest operator that joins two operands: `||`.
const LOOSEST: u8 = 1;
/// Of the operand of a sign: tighter than `*`, looser than `**`.
const SIGN: u8 = 8;
const POWER: u8 = 9;

/// One stretch of text that holds an expression.
pub(super) struct ExpressionParser<'a> {
    file: FileId,
    text: &'a str,
    bytes: &'a [u8],
    pos: usize,
    end: usize,
    /// Where byte 0 of `text` lies in the file.
    base: usize,
    nesting: u32,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'a> ExpressionParser<'a> {
    pub fn new(
        file: FileId,
        text: &'a str,
        range: std::ops::Range<usize>,
        base: usize,
        diagnostics: &'a mut Vec<Diagnostic>,
    ) -> Self {
        let bytes = text.as_bytes();
        ExpressionParser { file, text, bytes, pos: range.start, end: range.end, base, nesting: 0, diagnostics }
    }

    /// The whole stretch as one expression or as a bare tuple.
    pub fn whole(mut self) -> Expression {
        let (start, end) = (self.pos, self.end);
        match self.tuple_or_one() {
            Ok((expression, _)) => expression,
            Err(GivenUp) => Expression { span: self.span(start, end), kind: ExpressionKind::Broken },
        }
    }

    fn tuple_or_one(&mut self) -> Tree {
        let start = self.pos;
        let (mut items, height) = self.list(None)?;
        if items.len() == 1
            && let Some(only) = items.pop()
        {
            return Ok((only, height));
        }
        let span = self.span(start, self.pos);
        self.node(span, ExpressionKind::Tuple(items), height)
    }

    /// Comma separated expressions up to `close`, which is consumed, or up to the end.
    fn list(&mut self, close: Option<u8>) -> Trees {
        let mut items = Vec::new();
        let mut height = 0;
        loop {
            let (item, item_height) = self.expression()?;
            height = height.max(item_height);
            items.push(item);
            match self.peek() {
                Some(b',') => self.pos += 1,
                found if found == close => {
                    self.pos += usize::from(close.is_some());
                    return Ok((items, height));
                }
                _ => {
                    let wanted = match close {
                        Some(b')') => "`,` or `)`",
                        Some(b']') => "`,` or `]`",
                        Some(b'}') => "`,` or `}`",
                        _ => "an operator",
                    };
                    return Err(self.unexpected(wanted));
                }
            }
        }
    }

    /// Indices up to the closing bracket: single ones, or from the first to the last, `[4:6]`.
    fn indices(&mut self) -> Trees {
        let mut items = Vec::new();
        let mut height = 0;
        loop {
            let (mut item, mut item_height) = self.expression()?;
            if self.peek() == Some(b':') {
                let colon = self.span(self.pos, self.pos + 1);
                self.pos += 1;
                let (last, last_height) = self.expression()?;
                let span = item.span.to(last.span);
                let kind = ExpressionKind::Call {
                    function: RANGE.to_owned(),
                    function_span: colon,
                    arguments: vec![item, last],
                };
                (item, item_height) = self.node(span, kind, item_height.max(last_height))?;
            }
            height = height.max(item_height);
            items.push(item);
            match self.peek() {
                Some(b',') => self.pos += 1,
                Some(b']') => {
                    self.pos += 1;
                    return Ok((items, height));
                }
                _ => return Err(self.unexpected("`,`, `:` or `]`")),
            }
        }
    }

    fn expression(&mut self) -> Tree {
        self.nest()?;
        let condition = self.binary(LOOSEST)?;
        let tree = if self.peek() == Some(b'?') { self.conditional(condition)? } else { condition };
        self.nesting -= 1;
        Ok(tree)
    }

    fn conditional(&mut self, (condition, h0): (Expression, u32)) -> Tree {
        self.pos += 1;
        let (yes, h1) = self.expression()?;
        if self.peek() != Some(b':') {
            return Err(self.unexpected("an operator or the `:` of `condition ? a : b`"));
        }
        self.pos += 1;
        let (no, h2) = self.expression()?;
        let span = condition.span.to(no.span);
        let kind = ExpressionKind::Conditional(Box::new(condition), Box::new(yes), Box::new(no));
        self.node(span, kind, h0.max(h1).max(h2))
    }

    /// Operands joined by operators that bind at least as tightly as `least`.
    fn binary(&mut self, least: u8) -> Tree {
        let (mut left, mut height) = self.operand()?;
        while let Some((operator, strength, length)) = self.operator() {
            if strength < least {
                break;
            }
            self.pos += length;
            // A power takes a sign and further powers to its right: a**-b, a**b**c = a**(b**c).
            let (right, right_height) =
                if strength == POWER { self.nested_operand()? } else { self.binary(strength + 1)? };
            let span = left.span.to(right.span);
            let kind = ExpressionKind::Binary(operator, Box::new(left), Box::new(right));
            (left, height) = self.node(span, kind, height.max(right_height))?;
        }
        Ok((left, height))
    }

    fn nested_operand(&mut self) -> Tree {
        self.nest()?;
        let operand = self.binary(SIGN)?;
        self.nesting -= 1;
        Ok(operand)
    }

    fn operator(&mut self) -> Option<(BinaryOperator, u8, usize)> {
        use BinaryOperator as B;
        let first = self.peek()?;
        let second = if self.pos + 1 < self.end { self.bytes[self.pos + 1] } else { 0 };
        Some(match (first, second) {
            (b'|', b'|') => (B::Or, 1, 2),
            (b'&', b'&') => (B::And, 2, 2),
            (b'=', b'=') => (B::Equal, 3, 2),
            (b'!', b'=') => (B::NotEqual, 3, 2),
            (b'<', b'=') => (B::LessEqual, 4, 2),
            (b'<', _) => (B::Less, 4, 1),
            (b'>', b'=') => (B::GreaterEqual, 4, 2),
            (b'>', _) => (B::Greater, 4, 1),
            (b'/', b'/') => (B::Concatenate, 5, 2),
            (b'+', _) => (B::Add, 6, 1),
            (b'-', _) => (B::Subtract, 6, 1),
            (b'*', b'*') => (B::Power, POWER, 2),
            (b'*', _) => (B::Multiply, 7, 1),
            (b'/', _) => (B::Divide, 7, 1),
            _ => return None,
        })
    }

    /// A sign with its operand, or something that signs and operators work on.
    fn operand(&mut self) -> Tree {
        let operator = match self.peek() {
            Some(b'-') => UnaryOperator::Negate,
            Some(b'+') => UnaryOperator::Plus,
            Some(b'!') => UnaryOperator::Not,
            _ => return self.postfix(),
        };
        let start = self.pos;
        self.pos += 1;
        let (operand, height) = self.nested_operand()?;
        let span = self.span(start, start).to(operand.span);
        self.node(span, ExpressionKind::Unary(operator, Box::new(operand)), height)
    }

    /// An atom with what hangs on it: `[i]`, `.attribute`.
    fn postfix(&mut self) -> Tree {
        let (mut inner, mut height) = self.atom()?;
        loop {
            match self.bytes.get(self.pos).filter(|_| self.pos < self.end) {
                Some(b'[') => {
                    self.pos += 1;
                    let (indices, index_height) = self.indices()?;
                    let span = inner.span.to(self.span(self.pos, self.pos));
                    let kind = ExpressionKind::Index(Box::new(inner), indices);
                    (inner, height) = self.node(span, kind, height.max(index_height))?;
                }
                Some(b'.') => {
                    let start = self.pos + 1;
                    let end = self.end_of_name(start);
                    if end == start {
                        self.pos = start;
                        return Err(self.unexpected("the name of an attribute"));
                    }
                    self.pos = end;
                    let span = inner.span.to(self.span(end, end));
                    let name = self.text[start..end].to_owned();
                    (inner, height) = self.node(span, ExpressionKind::Attribute(Box::new(inner), name), height)?;
                }
                _ => return Ok((inner, height)),
            }
        }
    }

    fn atom(&mut self) -> Tree {
        let Some(first) = self.peek() else { return Err(self.unexpected("a value")) };
        let start = self.pos;
        match first {
            b'(' => {
                self.pos += 1;
                let (mut items, height) = self.list(Some(b')'))?;
                let span = self.span(start, self.pos);
                if items.len() == 1
                    && let Some(only) = items.pop()
                {
                    return Ok((Expression { span, ..only }, height));
                }
                self.node(span, ExpressionKind::Tuple(items), height)
            }
            b'{' => self.bracketed(b'}', ExpressionKind::Array),
            b'[' => self.bracketed(b']', ExpressionKind::Row),
            b'"' | b'\'' => {
                let Some(end) = end_of_string(self.bytes, start, self.end) else {
                    self.diagnostics.push(unclosed_quote(self.span(start, start + 1), false));
                    return Err(GivenUp);
                };
                self.pos = end;
                let text = unescape(&self.text[start..end]);
                Ok((Expression { span: self.span(start, end), kind: ExpressionKind::Text(text) }, 1))
            }
            b'0'..=b'9' | b'.' => match end_of_number(self.bytes, start).filter(|end| *end <= self.end) {
                Some(end) => self.number(start, end),
                None => self.name(start),
            },
            b if is_name(b) => self.name(start),
            _ => Err(self.unexpected("a value")),
        }
    }

    fn bracketed(&mut self, close: u8, kind: fn(Vec<Expression>) -> ExpressionKind) -> Tree {
        let start = self.pos;
        self.pos += 1;
        self.nest()?;
        let (items, height) = if self.peek() == Some(close) {
            self.pos += 1;
            (Vec::new(), 0)
        } else {
            self.list(Some(close))?
        };
        self.nesting -= 1;
        let span = self.span(start, self.pos);
        self.node(span, kind(items), height)
    }

    fn number(&mut self, start: usize, end: usize) -> Tree {
        let value = value_of(&self.text[start..end]);
        if value.is_infinite() {
            self.diagnostics.push(out_of_range(self.span(start, end), &self.text[start..end]));
            return Err(GivenUp);
        }
        self.pos = end;
        let unit = match self.bytes.get(end).filter(|_| end < self.end) {
            Some(b'(') => match cursor::closing(self.bytes, end, self.end) {
                Closing::At(close) => {
                    self.pos = close + 1;
                    Some(self.text[end + 1..close].trim().into())
                }
                Closing::Missing | Closing::QuoteOpen(_) => {
                    self.diagnostics.push(unclosed_parenthesis(self.span(end, end + 1)));
                    return Err(GivenUp);
                }
            },
            Some(b) if is_name(*b) => {
                while self.pos < self.end && is_name(self.bytes[self.pos]) {
                    self.pos += 1;
                }
                Some(self.text[end..self.pos].into())
            }
            _ => None,
        };
        Ok((Expression { span: self.span(start, self.pos), kind: ExpressionKind::Number { value, unit } }, 1))
    }

    fn name(&mut self, start: usize) -> Tree {
        let end = self.end_of_name(start);
        if end == start || self.text[start..end].bytes().all(|b| b == b'.') {
            return Err(self.unexpected("a value"));
        }
        self.pos = end;
        let name = self.text[start..end].to_owned();
        let span = self.span(start, end);
        if self.peek() != Some(b'(') {
            self.pos = end; // blanks behind a name do not belong to it
            return Ok((Expression { span, kind: ExpressionKind::Name(name) }, 1));
        }
        self.pos += 1;
        let (arguments, height) = if self.peek() == Some(b')') {
            self.pos += 1;
            (Vec::new(), 0)
        } else if name.eq_ignore_ascii_case("IF") {
            self.arguments_of_if()?
        } else {
            self.list(Some(b')'))?
        };
        let kind = ExpressionKind::Call { function: name, function_span: span, arguments };
        let span = self.span(start, self.pos);
        self.node(span, kind, height)
    }

    /// `IF(e: a, b, c)`, as run-time functions write it; a comma in place of the colon is read too.
    fn arguments_of_if(&mut self) -> Trees {
        let (condition, height) = self.expression()?;
        if !matches!(self.peek(), Some(b':' | b',')) {
            return Err(self.unexpected("the `:` of `IF(e: a, b, c)`"));
        }
        self.pos += 1;
        let (mut arguments, rest) = self.list(Some(b')'))?;
        arguments.insert(0, condition);
        Ok((arguments, height.max(rest)))
    }

    /// Offset behind a name with its dots and quoted parts.
    fn end_of_name(&self, start: usize) -> usize {
        let mut i = start;
        while i < self.end {
            i = match self.bytes[i] {
                b if is_name(b) || b == b'.' => i + 1,
                b'"' | b'\'' if i > start && matches!(self.bytes[i - 1], b'.' | b'$') => {
                    match end_of_string(self.bytes, i, self.end) {
                        Some(after) => after,
                        None => return i,
                    }
                }
                _ => return i,
            };
        }
        i
    }

    /// Skips blanks and looks at the next byte.
    fn peek(&mut self) -> Option<u8> {
        while self.pos < self.end {
            let b = self.bytes[self.pos];
            if !is_blank(b) && b != b'\n' {
                return Some(b);
            }
            self.pos += 1;
        }
        None
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, self.base + start, self.base + end)
    }

    fn node(&mut self, span: Span, kind: ExpressionKind, height_below: u32) -> Tree {
        if height_below >= MAX_HEIGHT {
            return Err(self.too_deep());
        }
        Ok((Expression { span, kind }, height_below + 1))
    }

    fn nest(&mut self) -> Result<(), GivenUp> {
        self.nesting += 1;
        if self.nesting > MAX_NESTING { Err(self.too_deep()) } else { Ok(()) }
    }

    fn too_deep(&mut self) -> GivenUp {
        let at = self.span_of_next();
        self.diagnostics.push(
            Diagnostic::error("syntax/nested-too-deeply", "this expression is nested too deeply")
                .at(at, "too deep from here on")
                .note(format!(
                    "{MAX_NESTING} levels of parentheses or signs and {MAX_HEIGHT} chained operators are read"
                ))
                .help("split it with a design variable"),
        );
        GivenUp
    }

    /// The next character, or an empty span at the end.
    fn span_of_next(&mut self) -> Span {
        let length = self.peek().map_or(0, |_| self.text[self.pos..].chars().next().map_or(0, char::len_utf8));
        self.span(self.pos, self.pos + length)
    }

    fn unexpected(&mut self, wanted: &str) -> GivenUp {
        let span = self.span_of_next();
        let found = &self.text[self.pos..self.pos + (span.end - span.start) as usize];
        let diagnostic = match found.bytes().next() {
            None => Diagnostic::error(
                "syntax/incomplete-expression",
                format!("the expression ends where {wanted} is needed"),
            )
            .at(span, format!("{wanted} is missing here")),
            Some(b) if is_control(b) => unexpected_character(span, found),
            Some(_) => Diagnostic::error(
                "syntax/unexpected-in-expression",
                format!("`{found}` stands where {wanted} is needed"),
            )
            .at(span, format!("{wanted} is needed here")),
        };
        self.diagnostics.push(diagnostic);
        GivenUp
    }
}
