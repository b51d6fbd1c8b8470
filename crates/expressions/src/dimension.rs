//! Which physical dimension an expression is certain to have: every leaf with a unit says so, and
//! all others are plain numbers that only scale it.

use model::{BinaryOperator, Database, Node, UnaryOperator};
use schema::{Dimension, Quantity, parse_unit_expression};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Certainty {
    /// A plain number: any dimension, as its place wants.
    Plain,
    Certain(Dimension),
    Unknown,
}

/// The dimension of a tree, if it is certain. Ratios of equal dimensions count as plain numbers.
pub(crate) fn certain_dimension(node: &Node) -> Option<Dimension> {
    match of(node) {
        Certainty::Certain(dimension) if dimension != Dimension::NONE => Some(dimension),
        _ => None,
    }
}

/// What the value of an expression is multiplied with where a field wants radians per unit of time
/// whatever the angle unit is: the size of that unit if the expression certainly is an angle, or an
/// angle per time, in it; else 1.
pub fn radians_per_time(node: &Node, wanted: Dimension, database: &Database) -> f64 {
    if wanted != Dimension::PER_TIME {
        return 1.0;
    }
    let found = match node {
        Node::Object(id) if database.get(*id).is_some() => {
            database.text(*id, "units").and_then(Quantity::named).map(|q| q.dimension)
        }
        _ => certain_dimension(node),
    };
    if found.is_some_and(is_rate_of_angle) { database.units().angle.si } else { 1.0 }
}

/// An angle per time, or an angle, which stands for one: `72d`.
pub fn is_rate_of_angle(dimension: Dimension) -> bool {
    matches!(dimension, Dimension::ANGLE | Dimension::ANGULAR_VELOCITY)
}

fn of(node: &Node) -> Certainty {
    use Certainty::{Certain, Plain, Unknown};
    match node {
        Node::Number { unit: None, .. } | Node::Constant("PI" | "DTOR" | "RTOD") => Plain,
        Node::Number { unit: Some(unit), .. } => {
            parse_unit_expression(crate::evaluate::bare_unit(unit)).map_or(Unknown, |(d, _)| Certain(d))
        }
        Node::Unary(UnaryOperator::Negate | UnaryOperator::Plus, inner) => of(inner),
        Node::Binary(operator, a, b) => match (operator, of(a), of(b)) {
            (_, Unknown, _) | (_, _, Unknown) => Unknown,
            (BinaryOperator::Multiply, a, b) => scaled(a, b, Dimension::times),
            (BinaryOperator::Divide, a, b) => scaled(a, b, Dimension::per),
            (BinaryOperator::Add | BinaryOperator::Subtract, a, b) if a == b => a,
            (BinaryOperator::Power, Plain, Plain) => Plain,
            (BinaryOperator::Power, Certain(d), Plain) => match **b {
                Node::Number { value, .. } if value.fract() == 0.0 && value.abs() <= 8.0 => {
                    Certain(d.power(value as i8))
                }
                _ => Unknown,
            },
            _ => Unknown,
        },
        Node::Array(items) | Node::Row(items) => {
            let mut all = items.iter().map(of);
            match all.next() {
                Some(first) if all.all(|c| c == first) => first,
                _ => Unknown,
            }
        }
        _ => Unknown,
    }
}

fn scaled(a: Certainty, b: Certainty, join: fn(Dimension, Dimension) -> Dimension) -> Certainty {
    use Certainty::{Certain, Plain};
    if (a, b) == (Plain, Plain) {
        return Plain;
    }
    let dimension = |c| if let Certain(d) = c { d } else { Dimension::NONE };
    Certain(join(dimension(a), dimension(b)))
}
