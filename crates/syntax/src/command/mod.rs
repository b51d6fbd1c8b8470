//! The grammar of Adams View command files: statements, arguments, values, expressions.

mod tree;

mod comments;
mod cursor;
mod expression;
mod format;
mod layout;
mod parser;
mod pieces;
mod troubles;

pub use crate::quoted::quote;
pub use comments::{Comment, Comments, comments};
pub use format::{Formatted, format};
pub use parser::{Parser, parse, parse_expression};
pub use tree::{
    Argument, BinaryOperator, Expression, ExpressionKind, Item, ItemKind, Items, RANGE, Statement, StatementKind,
    UnaryOperator,
};
