//! What a command file consists of. Spans point into the source, so nothing is lost: all text
//! between two tokens is blanks, comments and continuation marks.

use smallvec::SmallVec;
use text::Span;

/// One logical line.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// From the first to the last token, continuation lines included.
    pub span: Span,
    pub kind: StatementKind,
}

#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `force create element_like beam  ixx = 4 ...`: words before the first `name =`, then pairs.
    Command { keywords: Vec<Span>, arguments: Vec<Argument> },
    /// `.model.part.field = value` at the start of a line.
    Assignment { target: Span, values: Items },
    /// Text that could not be understood; diagnostics say why.
    Broken,
}

/// `parameter = value, value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    pub name: Span,
    /// Empty when nothing follows the `=`.
    pub values: Items,
    /// From the first to the last value; empty just behind the `=` if there is none.
    pub value_span: Span,
}

/// The values of one parameter: one, most of the time.
pub type Items = SmallVec<[Item; 1]>;

/// One value of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    pub span: Span,
    pub kind: ItemKind,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ItemKind {
    /// A plain number; an attached unit (`d`, `cm`) is kept as its text.
    Number { value: f64, unit: Option<Box<str>> },
    /// A quoted string, escapes resolved.
    Text(String),
    /// A plain word or a dotted object name, possibly with wildcards, quotes as typed.
    Word,
    /// `( ... )`: the tree of what is inside the outer parentheses.
    Expression(Box<Expression>),
}

/// One node of an expression as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    pub span: Span,
    pub kind: ExpressionKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOperator {
    Negate,
    Plus,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    Power,
    Multiply,
    Divide,
    Add,
    Subtract,
    Concatenate,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// Name of the call that `i:j` in an index is read as; no function can be named so.
pub const RANGE: &str = ":";

#[derive(Clone, Debug, PartialEq)]
pub enum ExpressionKind {
    /// `6inch`, `7801.0(kg/meter**3)`, `90d`: value as typed and the unit text without parentheses.
    Number {
        value: f64,
        unit: Option<Box<str>>,
    },
    Text(String),
    /// A name with its dots and quotes as typed: `.model.part."odd one".location`, `PI`, `part.cm`.
    Name(String),
    /// `f(a, b)`.
    Call {
        function: String,
        function_span: Span,
        arguments: Vec<Expression>,
    },
    /// `a[i]`, `a[i, j]`; `a[i:j]` with a call of [`RANGE`] as index.
    Index(Box<Expression>, Vec<Expression>),
    /// `.name` behind a closing parenthesis or bracket: `STOO("x").adams_id`.
    Attribute(Box<Expression>, String),
    Unary(UnaryOperator, Box<Expression>),
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
    Conditional(Box<Expression>, Box<Expression>, Box<Expression>),
    /// `{a, b}`.
    Array(Vec<Expression>),
    /// `[a, b]` inside braces.
    Row(Vec<Expression>),
    /// A bare tuple `(a, b, c)`.
    Tuple(Vec<Expression>),
    /// Text that could not be understood; a diagnostic says why.
    Broken,
}
