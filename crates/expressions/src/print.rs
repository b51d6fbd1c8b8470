//! The normalised text of an expression, as exports show it: function names in capitals, objects
//! by full name, blanks round operators except `**`, units kept behind their numbers. Reading it
//! gives the same expression.

use std::fmt::Write as _;

use model::{BinaryOperator, Database, Expression, Node, UnaryOperator};

/// Writes an expression, without the parentheses that enclose it in a command.
pub fn print(expression: &Expression, database: &Database) -> String {
    let mut out = String::new();
    write(&expression.root, 0, database, &mut out);
    out
}

/// Binding strength, as in the grammar; higher binds tighter.
fn strength(node: &Node) -> u8 {
    match node {
        Node::Conditional(..) => 1,
        Node::Binary(operator, ..) => operator_of(*operator).1,
        Node::Unary(..) => 9,
        _ => 11,
    }
}

fn operator_of(operator: BinaryOperator) -> (&'static str, u8) {
    use BinaryOperator as B;
    match operator {
        B::Or => ("||", 2),
        B::And => ("&&", 3),
        B::Equal => ("==", 4),
        B::NotEqual => ("!=", 4),
        B::Less => ("<", 5),
        B::LessEqual => ("<=", 5),
        B::Greater => (">", 5),
        B::GreaterEqual => (">=", 5),
        B::Concatenate => ("//", 6),
        B::Add => ("+", 7),
        B::Subtract => ("-", 7),
        B::Multiply => ("*", 8),
        B::Divide => ("/", 8),
        B::Power => ("**", 10),
    }
}

/// Writes a node; in parentheses if it binds less tightly than `least`.
fn write(node: &Node, least: u8, database: &Database, out: &mut String) {
    if strength(node) < least {
        out.push('(');
        write(node, 0, database, out);
        out.push(')');
        return;
    }
    match node {
        Node::Number { text, unit, .. } => {
            out.push_str(text);
            out.push_str(unit.as_deref().unwrap_or(""));
        }
        Node::Text(text) => write_text(text, out),
        Node::Nothing => out.push_str("NONE"),
        Node::Constant(name) => out.push_str(name),
        Node::Object(id) => match database.get(*id) {
            Some(_) => out.push_str(&database.full_name(*id)),
            None => out.push_str("NONE"),
        },
        Node::Attribute(inner, name) => {
            // Behind a dotted name the attribute reads as a part of it; so does a bracket or call.
            write(inner, 11, database, out);
            out.push('.');
            out.push_str(name);
        }
        Node::Index(inner, indices) => {
            write(inner, 11, database, out);
            list('[', indices, ']', database, out);
        }
        Node::Call { function, arguments } if &**function == syntax::command::RANGE => {
            for (i, end) in arguments.iter().enumerate() {
                if i > 0 {
                    out.push(':');
                }
                write(end, 2, database, out);
            }
        }
        Node::Call { function, arguments } => {
            out.push_str(function);
            list('(', arguments, ')', database, out);
        }
        Node::Unary(operator, inner) => {
            out.push(match operator {
                UnaryOperator::Negate => '-',
                UnaryOperator::Plus => '+',
                UnaryOperator::Not => '!',
            });
            write(inner, 9, database, out);
        }
        Node::Binary(operator, a, b) => {
            let (sign, own) = operator_of(*operator);
            // Equal strength joins to the left; powers get parentheses on either side.
            let left = if *operator == BinaryOperator::Power { 11 } else { own };
            write(a, left, database, out);
            match operator {
                BinaryOperator::Power => out.push_str(sign),
                _ => {
                    let _ = write!(out, " {sign} ");
                }
            }
            write(b, if *operator == BinaryOperator::Power { 11 } else { own + 1 }, database, out);
        }
        Node::Conditional(condition, yes, no) => {
            write(condition, 2, database, out);
            out.push_str(" ? ");
            write(yes, 2, database, out);
            out.push_str(" : ");
            write(no, 2, database, out);
        }
        Node::Array(items) => list('{', items, '}', database, out),
        Node::Row(items) => list('[', items, ']', database, out),
        Node::Unbound(name) => out.push_str(name),
    }
}

fn list(open: char, items: &[Node], close: char, database: &Database, out: &mut String) {
    out.push(open);
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        write(item, 0, database, out);
    }
    out.push(close);
}

fn write_text(text: &str, out: &mut String) {
    out.push('"');
    for c in text.chars() {
        if matches!(c, '"' | '\\') {
            out.push('\\');
        }
        out.push(c);
    }
    out.push('"');
}

/// The shortest text of a real that reads back to the same value and shows that it is real:
/// `2.0`, `2.5`, `1.0E+20`, `1.5E-07`.
pub fn number_text(x: f64) -> String {
    let magnitude = x.abs();
    if magnitude != 0.0 && !(1e-4..1e10).contains(&magnitude) {
        return normalised(&format!("{x:E}"));
    }
    format!("{x:?}")
}

/// A number as typed, brought to the form exports show; the digits stay. Digits alone stay an
/// integer; a real gets a digit on both sides of its point and an exponent of a sign and two digits.
pub(crate) fn normalised(typed: &str) -> String {
    let typed = typed.trim();
    if crate::evaluate::is_integer_text(typed) {
        return typed.to_string();
    }
    let (mantissa, exponent) = match typed.find(['e', 'E']) {
        Some(at) => (&typed[..at], Some(&typed[at + 1..])),
        None => (typed, None),
    };
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", mantissa),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let mut out = format!(
        "{sign}{}.{}",
        if whole.is_empty() { "0" } else { whole },
        if fraction.is_empty() { "0" } else { fraction }
    );
    if let Some(exponent) = exponent {
        let (sign, digits) = match exponent.strip_prefix('-') {
            Some(digits) => ('-', digits),
            None => ('+', exponent.strip_prefix('+').unwrap_or(exponent)),
        };
        let digits = digits.trim_start_matches('0');
        let _ = write!(out, "E{sign}{digits:0>2}");
    }
    out
}
