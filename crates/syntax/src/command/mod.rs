//! The grammar of Adams View command files: statements, arguments, values, expressions.

mod tree;

mod comments;
mod cursor;
mod expression;
mod parser;
mod troubles;

pub use crate::quoted::quote;
pub use comments::{Comment, Comments, comments};
pub use parser::{Parser, parse, parse_expression};
pub use tree::{
    Argument, BinaryOperator, Expression, ExpressionKind, Item, ItemKind, Statement, StatementKind, UnaryOperator,
};
