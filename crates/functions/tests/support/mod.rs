//! A resolver with numbered markers and a small reader of function text.
#![allow(dead_code)] // each test file uses its own part

use flexure_functions::{Function, Resolver, compile};
use syntax::function::{FunctionExpression, FunctionKind, FunctionOperator};
use text::{Diagnostic, FileId, Span};

/// Markers are called by their number or by `m<number>`; element `e` exists; `dv` is 2.5.
pub struct Bench;

impl Resolver for Bench {
    fn marker(&mut self, name: &str) -> Result<u32, String> {
        name.trim_start_matches('m').parse().map_err(|_| format!("no marker named `{name}`"))
    }
    fn element(&mut self, function: &str, name: &str) -> Result<u32, String> {
        if name == "e" { Ok(7) } else { Err(format!("no element for {function} named `{name}`")) }
    }
    fn number(&mut self, name: &str) -> Result<f64, String> {
        if name == "dv" { Ok(2.5) } else { Err(format!("`{name}` is nothing")) }
    }
}

pub fn function(text: &str) -> Function {
    compile(&parse(text), &mut Bench).unwrap_or_else(|e| panic!("{text}: {e:#?}"))
}

pub fn errors(text: &str) -> Vec<Diagnostic> {
    compile(&parse(text), &mut Bench).expect_err(text)
}

/// Value of a function of constants or of time 0.
pub fn number(text: &str) -> f64 {
    function(text).value(0.0, &[])
}

pub fn parse(text: &str) -> FunctionExpression {
    let mut p = Reader { text, at: 0 };
    let e = p.sum();
    assert_eq!(p.peek(), None, "{text}");
    e
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<u8> {
        while self.text.as_bytes().get(self.at) == Some(&b' ') {
            self.at += 1;
        }
        self.text.as_bytes().get(self.at).copied()
    }
    fn eat(&mut self, word: &str) -> bool {
        self.peek();
        let found = self.text[self.at..].starts_with(word);
        self.at += if found { word.len() } else { 0 };
        found
    }
    fn make(&self, start: usize, kind: FunctionKind) -> FunctionExpression {
        FunctionExpression { span: Span::new(FileId(0), start, self.at), kind }
    }
    fn sum(&mut self) -> FunctionExpression {
        let start = self.at;
        let mut left = self.product();
        loop {
            let operator = if self.eat("+") {
                FunctionOperator::Add
            } else if self.eat("-") {
                FunctionOperator::Subtract
            } else {
                return left;
            };
            let right = self.product();
            left = self.make(start, FunctionKind::Binary(operator, left.into(), right.into()));
        }
    }
    fn product(&mut self) -> FunctionExpression {
        let start = self.at;
        let mut left = self.factor();
        loop {
            let operator = if self.eat("*") {
                FunctionOperator::Multiply
            } else if self.eat("/") {
                FunctionOperator::Divide
            } else {
                return left;
            };
            let right = self.factor();
            left = self.make(start, FunctionKind::Binary(operator, left.into(), right.into()));
        }
    }
    fn factor(&mut self) -> FunctionExpression {
        let start = self.at;
        if self.eat("-") {
            let inner = self.factor();
            return self.make(start, FunctionKind::Negate(inner.into()));
        }
        let base = self.atom();
        if !self.eat("**") {
            return base;
        }
        let exponent = self.factor();
        self.make(start, FunctionKind::Binary(FunctionOperator::Power, base.into(), exponent.into()))
    }
    fn atom(&mut self) -> FunctionExpression {
        if self.eat("(") {
            let inner = self.sum();
            assert!(self.eat(")"));
            return inner;
        }
        self.peek();
        let start = self.at;
        let rest = &self.text[start..];
        if rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let bytes = rest.as_bytes();
            let mut end = 0;
            while bytes.get(end).is_some_and(|&b| {
                b.is_ascii_digit() || b == b'.' || b == b'E' || (matches!(b, b'-' | b'+') && bytes[end - 1] == b'E')
            }) {
                end += 1;
            }
            let mut x: f64 = rest[..end].parse().unwrap();
            self.at += end;
            if self.eat("D") {
                x *= std::f64::consts::PI / 180.0;
            }
            return self.make(start, FunctionKind::Number(x));
        }
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let name = rest[..end].to_string();
        self.at += end;
        let function_span = Span::new(FileId(0), start, self.at);
        if !self.eat("(") {
            return self.make(start, FunctionKind::Name(name));
        }
        let mut arguments = Vec::new();
        while !self.eat(")") {
            arguments.push(self.sum());
            let _ = self.eat(",") || self.eat(":");
        }
        self.make(start, FunctionKind::Call { function: name, function_span, arguments })
    }
}
