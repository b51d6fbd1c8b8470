//! The grammar of Adams View command files: statements, arguments, values, expressions.

mod tree;

pub use tree::{
    Argument, BinaryOperator, Expression, ExpressionKind, Item, ItemKind, Statement, StatementKind, UnaryOperator,
};
