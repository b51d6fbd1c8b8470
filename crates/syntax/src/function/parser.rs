//! Run-time functions: precedence climbing. Blanks and line breaks mean nothing, letters mean the
//! same in either case, `D` behind a literal turns degrees into radians.

use text::{Diagnostic, FileId, Span};

use super::tree::{FunctionExpression, FunctionKind, FunctionOperator};
use crate::number::{end_of_number, value_of};
use crate::quoted::end_of_string;
use crate::{MAX_HEIGHT, MAX_NESTING};

/// The diagnostic has been pushed; the expression is given up.
struct GivenUp;

/// A tree with its height.
type Tree = Result<(FunctionExpression, u32), GivenUp>;

struct Parser<'a> {
    file: FileId,
    text: &'a str,
    bytes: &'a [u8],
    pos: usize,
    base: usize,
    nesting: u32,
    diagnostics: Vec<Diagnostic>,
}

/// A whole text as one run-time function. `base_offset` is where the text begins in the file; spans
/// are exact as long as the text is a verbatim part of the file (one string without escapes).
/// What is not understood becomes one broken node with one diagnostic.
pub fn parse(file: FileId, text: &str, base_offset: usize) -> (FunctionExpression, Vec<Diagnostic>) {
    let mut parser =
        Parser { file, text, bytes: text.as_bytes(), pos: 0, base: base_offset, nesting: 0, diagnostics: Vec::new() };
    let tree = parser.sum().and_then(|tree| match parser.peek() {
        None => Ok(tree),
        Some(_) => Err(parser.unexpected("an operator")),
    });
    let tree = match tree {
        Ok((tree, _)) => tree,
        Err(GivenUp) => FunctionExpression { span: parser.span(0, text.len()), kind: FunctionKind::Broken },
    };
    (tree, parser.diagnostics)
}

impl Parser<'_> {
    fn sum(&mut self) -> Tree {
        self.nest()?;
        let (mut left, mut height) = self.product()?;
        loop {
            let operator = match self.peek() {
                Some(b'+') => FunctionOperator::Add,
                Some(b'-') => FunctionOperator::Subtract,
                _ => break,
            };
            self.pos += 1;
            let (right, right_height) = self.product()?;
            (left, height) = self.binary(operator, left, right, height.max(right_height))?;
        }
        self.nesting -= 1;
        Ok((left, height))
    }

    fn product(&mut self) -> Tree {
        let (mut left, mut height) = self.factor()?;
        loop {
            let operator = match self.peek() {
                Some(b'*') => FunctionOperator::Multiply,
                Some(b'/') => FunctionOperator::Divide,
                _ => return Ok((left, height)),
            };
            self.pos += 1;
            let (right, right_height) = self.factor()?;
            (left, height) = self.binary(operator, left, right, height.max(right_height))?;
        }
    }

    /// A sign binds looser than a power: `-x**2` is `-(x**2)`.
    fn factor(&mut self) -> Tree {
        let start = self.pos;
        let first = self.peek();
        if !matches!(first, Some(b'-' | b'+')) {
            return self.power();
        }
        let sign_at = self.pos.max(start);
        self.pos += 1;
        self.nest()?;
        let (operand, height) = self.factor()?;
        self.nesting -= 1;
        if first == Some(b'+') {
            return Ok((operand, height));
        }
        let span = self.span(sign_at, sign_at).to(operand.span);
        self.node(span, FunctionKind::Negate(Box::new(operand)), height)
    }

    fn power(&mut self) -> Tree {
        let (base, height) = self.atom()?;
        if self.peek() != Some(b'*') || self.bytes.get(self.pos + 1) != Some(&b'*') {
            return Ok((base, height));
        }
        self.pos += 2;
        self.nest()?;
        let (exponent, exponent_height) = self.factor()?;
        self.nesting -= 1;
        self.binary(FunctionOperator::Power, base, exponent, height.max(exponent_height))
    }

    fn atom(&mut self) -> Tree {
        let Some(first) = self.peek() else { return Err(self.unexpected("a value")) };
        let start = self.pos;
        if first == b'(' {
            self.pos += 1;
            let (inside, height) = self.sum()?;
            self.expect(b')', "an operator or `)`")?;
            let span = self.span(start, self.pos);
            return Ok((FunctionExpression { span, ..inside }, height));
        }
        if let Some(end) = end_of_number(self.bytes, start) {
            return self.number(start, end);
        }
        let end = self.end_of_name(start);
        if end == start || self.bytes[start..end].iter().all(|b| *b == b'.') {
            return Err(self.unexpected("a value"));
        }
        self.pos = end;
        let name = self.text[start..end].to_owned();
        let span = self.span(start, end);
        if self.peek() == Some(b'(') {
            self.pos += 1;
            return self.call(name, span);
        }
        Ok((FunctionExpression { span, kind: FunctionKind::Name(name) }, 1))
    }

    fn number(&mut self, start: usize, end: usize) -> Tree {
        let literal = &self.text[start..end];
        let mut value = value_of(literal);
        if value.is_infinite() {
            let span = self.span(start, end);
            self.diagnostics.push(
                Diagnostic::error("function/number-out-of-range", format!("the number {literal} is too large"))
                    .at(span, "infinite")
                    .note("the largest number is 1.797E+308"),
            );
            return Err(GivenUp);
        }
        self.pos = end;
        if let Some(b'd' | b'D') = self.bytes.get(end) {
            value = value.to_radians();
            self.pos += 1;
        }
        if self.bytes.get(self.pos).is_some_and(|b| is_name(*b)) {
            return Err(self.unexpected("an operator"));
        }
        Ok((FunctionExpression { span: self.span(start, self.pos), kind: FunctionKind::Number(value) }, 1))
    }

    /// Arguments behind the opening parenthesis. `IF(e: a, b, c)` has a colon behind its first one.
    fn call(&mut self, function: String, function_span: Span) -> Tree {
        let is_if = function.eq_ignore_ascii_case("IF");
        let mut arguments = Vec::new();
        let mut height = 0;
        if self.peek() == Some(b')') {
            self.pos += 1;
        } else {
            loop {
                let (argument, argument_height) = self.sum()?;
                arguments.push(argument);
                height = height.max(argument_height);
                match self.peek() {
                    Some(b')') => {
                        self.pos += 1;
                        break;
                    }
                    Some(b':') if is_if && arguments.len() == 1 => self.pos += 1,
                    _ if is_if && arguments.len() == 1 => return Err(self.unexpected("the `:` of `IF(e: a, b, c)`")),
                    Some(b',') => self.pos += 1,
                    _ => return Err(self.unexpected("`,` or `)`")),
                }
            }
        }
        let span = function_span.to(self.span(self.pos, self.pos));
        self.node(span, FunctionKind::Call { function, function_span, arguments }, height)
    }

    /// Offset behind a name with its dots and quoted parts.
    fn end_of_name(&self, start: usize) -> usize {
        let mut i = start;
        while let Some(&b) = self.bytes.get(i) {
            i = match b {
                b if is_name(b) || b == b'.' => i + 1,
                b'"' if i == start || self.bytes[i - 1] == b'.' => {
                    match end_of_string(self.bytes, i, self.bytes.len()) {
                        Some(after) => after,
                        None => return i,
                    }
                }
                _ => return i,
            };
        }
        i
    }

    fn peek(&mut self) -> Option<u8> {
        while let Some(&b) = self.bytes.get(self.pos) {
            if !b.is_ascii_whitespace() && b != 0x0b {
                return Some(b);
            }
            self.pos += 1;
        }
        None
    }

    fn expect(&mut self, wanted: u8, words: &str) -> Result<(), GivenUp> {
        if self.peek() == Some(wanted) {
            self.pos += 1;
            return Ok(());
        }
        Err(self.unexpected(words))
    }

    fn binary(
        &mut self,
        operator: FunctionOperator,
        a: FunctionExpression,
        b: FunctionExpression,
        height: u32,
    ) -> Tree {
        let span = a.span.to(b.span);
        self.node(span, FunctionKind::Binary(operator, Box::new(a), Box::new(b)), height)
    }

    fn node(&mut self, span: Span, kind: FunctionKind, height_below: u32) -> Tree {
        if height_below >= MAX_HEIGHT {
            return Err(self.too_deep());
        }
        Ok((FunctionExpression { span, kind }, height_below + 1))
    }

    fn nest(&mut self) -> Result<(), GivenUp> {
        self.nesting += 1;
        if self.nesting > MAX_NESTING { Err(self.too_deep()) } else { Ok(()) }
    }

    fn too_deep(&mut self) -> GivenUp {
        let span = self.span_of_next();
        self.diagnostics.push(
            Diagnostic::error("function/nested-too-deeply", "this function is nested too deeply")
                .at(span, "too deep from here on")
                .note(format!(
                    "{MAX_NESTING} levels of parentheses or signs and {MAX_HEIGHT} chained operators are read"
                ))
                .help("split it with a state variable"),
        );
        GivenUp
    }

    fn unexpected(&mut self, wanted: &str) -> GivenUp {
        let span = self.span_of_next();
        let found = &self.text[self.pos..self.pos + (span.end - span.start) as usize];
        let diagnostic = match found {
            "" => Diagnostic::error("function/incomplete", format!("the function ends where {wanted} is needed"))
                .at(span, format!("{wanted} is missing here")),
            "\"" => Diagnostic::error("function/unclosed-quote", "a quoted name is not closed").at(span, "opened here"),
            _ => Diagnostic::error(
                "function/unexpected",
                format!("`{}` stands where {wanted} is needed", found.escape_debug()),
            )
            .at(span, format!("{wanted} is needed here")),
        };
        self.diagnostics.push(diagnostic);
        GivenUp
    }

    /// The next character, or an empty span at the end.
    fn span_of_next(&mut self) -> Span {
        let length = self.peek().map_or(0, |_| self.text[self.pos..].chars().next().map_or(0, char::len_utf8));
        self.span(self.pos, self.pos + length)
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, self.base + start, self.base + end)
    }
}

fn is_name(b: u8) -> bool {
    b.is_ascii_alphanumeric() || matches!(b, b'_' | b'$' | 0x80..)
}
