//! Trees as short text: `(+ a (* 2 b))`, and statements as one line per argument.
#![allow(dead_code)] // every test file uses its part of it

use std::fmt::Write;

use flexure_syntax::command::{
    BinaryOperator, Expression, ExpressionKind, Item, ItemKind, Statement, StatementKind, UnaryOperator, parse,
    parse_expression,
};
use flexure_syntax::function::{self, FunctionExpression, FunctionKind, FunctionOperator};
use text::FileId;

pub const FILE: FileId = FileId(0);

/// The statements of a text that has no trouble.
pub fn clean(text: &str) -> Vec<Statement> {
    let (statements, diagnostics) = parse(FILE, text);
    assert!(diagnostics.is_empty(), "{text:?} gives {diagnostics:#?}");
    statements
}

/// All statements of a text as text, joined by ` ; `.
pub fn shape(text: &str) -> String {
    clean(text).iter().map(|s| statement(text, s)).collect::<Vec<_>>().join(" ; ")
}

/// The codes of all troubles with the text they point at.
pub fn codes(text: &str) -> Vec<(&'static str, &str)> {
    parse(FILE, text).1.iter().map(|d| (d.code, d.primary.as_ref().map_or("", |l| &text[l.span.range()]))).collect()
}

/// An expression that has no trouble.
pub fn tree(text: &str) -> String {
    let (tree, diagnostics) = parse_expression(FILE, text, 0);
    assert!(diagnostics.is_empty(), "{text:?} gives {diagnostics:#?}");
    expression(&tree)
}

/// A run-time function that has no trouble.
pub fn function(text: &str) -> String {
    let (tree, diagnostics) = function::parse(FILE, text, 0);
    assert!(diagnostics.is_empty(), "{text:?} gives {diagnostics:#?}");
    function_tree(&tree)
}

pub fn statement(text: &str, statement: &Statement) -> String {
    match &statement.kind {
        StatementKind::Command { keywords, arguments } => {
            let mut out = keywords.iter().map(|k| &text[k.range()]).collect::<Vec<_>>().join(" ");
            for a in arguments {
                write!(out, " | {} = {}", &text[a.name.range()], items(text, &a.values)).unwrap();
            }
            out
        }
        StatementKind::Assignment { target, values } => format!("{} := {}", &text[target.range()], items(text, values)),
        StatementKind::Broken => "broken".to_owned(),
    }
}

fn items(text: &str, items: &[Item]) -> String {
    items.iter().map(|i| item(text, i)).collect::<Vec<_>>().join(", ")
}

fn item(text: &str, item: &Item) -> String {
    match &item.kind {
        ItemKind::Number { value, unit: None } => format!("{value:?}"),
        ItemKind::Number { value, unit: Some(unit) } => format!("{value:?}<{unit}>"),
        ItemKind::Text(inside) => format!("{inside:?}"),
        ItemKind::Word => text[item.span.range()].to_owned(),
        ItemKind::Expression(tree) => format!("({})", expression(tree)),
    }
}

pub fn expression(tree: &Expression) -> String {
    let list = |all: &[Expression]| all.iter().map(expression).collect::<Vec<_>>().join(" ");
    match &tree.kind {
        ExpressionKind::Number { value, unit: None } => format!("{value:?}"),
        ExpressionKind::Number { value, unit: Some(unit) } => format!("{value:?}<{unit}>"),
        ExpressionKind::Text(text) => format!("{text:?}"),
        ExpressionKind::Name(name) => name.clone(),
        ExpressionKind::Call { function, arguments, .. } => format!("{function}({})", list(arguments)),
        ExpressionKind::Index(inner, indices) => format!("(at {} {})", expression(inner), list(indices)),
        ExpressionKind::Attribute(inner, name) => format!("(of {} {name})", expression(inner)),
        ExpressionKind::Unary(operator, inner) => {
            let sign = match operator {
                UnaryOperator::Negate => "-",
                UnaryOperator::Plus => "+",
                UnaryOperator::Not => "!",
            };
            format!("({sign} {})", expression(inner))
        }
        ExpressionKind::Binary(operator, a, b) => {
            let sign = match operator {
                BinaryOperator::Power => "**",
                BinaryOperator::Multiply => "*",
                BinaryOperator::Divide => "/",
                BinaryOperator::Add => "+",
                BinaryOperator::Subtract => "-",
                BinaryOperator::Concatenate => "//",
                BinaryOperator::Less => "<",
                BinaryOperator::LessEqual => "<=",
                BinaryOperator::Greater => ">",
                BinaryOperator::GreaterEqual => ">=",
                BinaryOperator::Equal => "==",
                BinaryOperator::NotEqual => "!=",
                BinaryOperator::And => "&&",
                BinaryOperator::Or => "||",
            };
            format!("({sign} {} {})", expression(a), expression(b))
        }
        ExpressionKind::Conditional(c, a, b) => format!("(? {} {} {})", expression(c), expression(a), expression(b)),
        ExpressionKind::Array(all) => format!("{{{}}}", list(all)),
        ExpressionKind::Row(all) => format!("[{}]", list(all)),
        ExpressionKind::Tuple(all) => format!("(tuple {})", list(all)),
        ExpressionKind::Broken => "broken".to_owned(),
    }
}

pub fn function_tree(tree: &FunctionExpression) -> String {
    match &tree.kind {
        FunctionKind::Number(value) => format!("{value:?}"),
        FunctionKind::Name(name) => name.clone(),
        FunctionKind::Call { function, arguments, .. } => {
            format!("{function}({})", arguments.iter().map(function_tree).collect::<Vec<_>>().join(" "))
        }
        FunctionKind::Negate(inner) => format!("(- {})", function_tree(inner)),
        FunctionKind::Binary(operator, a, b) => {
            let sign = match operator {
                FunctionOperator::Add => "+",
                FunctionOperator::Subtract => "-",
                FunctionOperator::Multiply => "*",
                FunctionOperator::Divide => "/",
                FunctionOperator::Power => "**",
            };
            format!("({sign} {} {})", function_tree(a), function_tree(b))
        }
        FunctionKind::Broken => "broken".to_owned(),
    }
}
