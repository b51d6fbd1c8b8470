//! What a run-time function consists of.

use text::Span;

#[derive(Clone, Debug, PartialEq)]
pub struct FunctionExpression {
    pub span: Span,
    pub kind: FunctionKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionOperator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

#[derive(Clone, Debug, PartialEq)]
pub enum FunctionKind {
    /// A literal; a `D` suffix (degrees) is already turned into radians.
    Number(f64),
    /// TIME, PI, DTOR, RTOD, MODE or an object name used as an argument.
    Name(String),
    /// `f(a, b)`; `IF(e: a, b, c)` is a call of `IF` with four arguments.
    Call {
        function: String,
        function_span: Span,
        arguments: Vec<FunctionExpression>,
    },
    Negate(Box<FunctionExpression>),
    Binary(FunctionOperator, Box<FunctionExpression>, Box<FunctionExpression>),
    Broken,
}
