//! Operators on values. Comparisons give 1 or 0; arrays work element by element, except that `*`
//! multiplies matrices whose shapes fit.

use model::{Array, BinaryOperator, UnaryOperator, Value};

use crate::{
    Scope,
    evaluate::describe,
    print::number_text,
    scope::{Outcome, problem},
};

/// A program that doubles a text in a loop would take all memory.
const LONGEST_TEXT: usize = 10_000_000;

pub(crate) fn flag(yes: bool) -> Value {
    Value::Integer(i64::from(yes))
}

/// Whether a value counts as true.
pub(crate) fn truth(value: &Value) -> Outcome<bool> {
    match value {
        Value::Nothing => Ok(false),
        Value::Object(_) => Ok(true),
        other => other.as_number().map(|x| x != 0.0).ok_or_else(|| not_a_number(other)),
    }
}

pub(crate) fn not_a_number(value: &Value) -> Box<text::Diagnostic> {
    problem("expression/not-a-number", format!("a number is needed here, not {}", describe(value)))
}

pub(crate) fn unary(operator: UnaryOperator, value: &Value) -> Outcome<Value> {
    Ok(match (operator, value) {
        (UnaryOperator::Not, value) => flag(!truth(value)?),
        (UnaryOperator::Plus, Value::Array(_) | Value::Integer(_) | Value::Number(_)) => value.clone(),
        (UnaryOperator::Negate, Value::Integer(i)) if i.checked_neg().is_some() => Value::Integer(-i),
        (UnaryOperator::Negate, Value::Array(array)) if array.values.len() != 1 => {
            Value::Array(Array { values: array.values.iter().map(|x| -x).collect(), ..array.clone() })
        }
        (UnaryOperator::Negate | UnaryOperator::Plus, value) => {
            let x = value.as_number().ok_or_else(|| not_a_number(value))?;
            Value::Number(if operator == UnaryOperator::Negate { -x } else { x })
        }
    })
}

pub(crate) fn binary(operator: BinaryOperator, a: &Value, b: &Value, scope: &Scope) -> Outcome<Value> {
    use BinaryOperator as B;
    match operator {
        B::Concatenate => {
            let text = text_of(a, scope)? + &text_of(b, scope)?;
            if text.len() > LONGEST_TEXT {
                let what = format!("`//` makes a text of more than {LONGEST_TEXT} bytes");
                return Err(problem("expression/text-too-long", what));
            }
            Ok(Value::Text(text))
        }
        B::Equal => Ok(flag(equal(a, b, scope)?)),
        B::NotEqual => Ok(flag(!equal(a, b, scope)?)),
        B::Less | B::LessEqual | B::Greater | B::GreaterEqual => {
            let order = match (a, b) {
                (Value::Text(a), Value::Text(b)) => Some(a.cmp(b)),
                _ => number(a)?.partial_cmp(&number(b)?),
            };
            Ok(flag(order.is_some_and(|o| match operator {
                B::Less => o.is_lt(),
                B::LessEqual => o.is_le(),
                B::Greater => o.is_gt(),
                _ => o.is_ge(),
            })))
        }
        B::And => Ok(flag(truth(a)? && truth(b)?)),
        B::Or => Ok(flag(truth(a)? || truth(b)?)),
        B::Add | B::Subtract | B::Multiply | B::Divide | B::Power => arithmetic(operator, a, b),
    }
}

fn number(value: &Value) -> Outcome<f64> {
    value.as_number().ok_or_else(|| not_a_number(value))
}

fn arithmetic(operator: BinaryOperator, a: &Value, b: &Value) -> Outcome<Value> {
    if let (Value::Integer(x), Value::Integer(y)) = (a, b) {
        let exact = match operator {
            BinaryOperator::Add => x.checked_add(*y),
            BinaryOperator::Subtract => x.checked_sub(*y),
            BinaryOperator::Multiply => x.checked_mul(*y),
            BinaryOperator::Power => u32::try_from(*y).ok().and_then(|y| x.checked_pow(y)),
            _ => None,
        };
        if let Some(exact) = exact {
            return Ok(Value::Integer(exact));
        }
    }
    match (a, b) {
        (Value::Array(x), Value::Array(y)) if x.values.len() != 1 && y.values.len() != 1 => {
            let product = operator == BinaryOperator::Multiply && x.columns == y.rows;
            if product && (x.rows, x.columns) != (y.rows, y.columns) || product && x.rows > 1 && x.rows == x.columns {
                return Ok(Value::Array(matrix_product(x, y)));
            }
            if (x.rows, x.columns) != (y.rows, y.columns) {
                return Err(problem(
                    "expression/shapes-differ",
                    format!(
                        "a {} x {} array and a {} x {} array cannot be combined element by element",
                        x.rows, x.columns, y.rows, y.columns
                    ),
                ));
            }
            let values =
                x.values.iter().zip(&y.values).map(|(x, y)| scalar(operator, *x, *y)).collect::<Outcome<_>>()?;
            Ok(Value::Array(Array { values, ..x.clone() }))
        }
        (Value::Array(x), y) if x.values.len() != 1 => {
            let y = number(y)?;
            let values = x.values.iter().map(|x| scalar(operator, *x, y)).collect::<Outcome<_>>()?;
            Ok(Value::Array(Array { values, ..x.clone() }))
        }
        (x, Value::Array(y)) if y.values.len() != 1 => {
            let x = number(x)?;
            let values = y.values.iter().map(|y| scalar(operator, x, *y)).collect::<Outcome<_>>()?;
            Ok(Value::Array(Array { values, ..y.clone() }))
        }
        _ => Ok(Value::Number(scalar(operator, number(a)?, number(b)?)?)),
    }
}

fn scalar(operator: BinaryOperator, x: f64, y: f64) -> Outcome<f64> {
    let result = match operator {
        BinaryOperator::Add => x + y,
        BinaryOperator::Subtract => x - y,
        BinaryOperator::Multiply => x * y,
        BinaryOperator::Divide => {
            if y == 0.0 {
                return Err(problem("expression/division-by-zero", format!("{} is divided by zero", number_text(x))));
            }
            x / y
        }
        _ => match y {
            // Whole powers by multiplication, which is exact where the product is.
            y if y.fract() == 0.0 && y.abs() <= 64.0 => x.powi(y as i32),
            y => x.powf(y),
        },
    };
    if result.is_finite() {
        Ok(result)
    } else {
        let sign = match operator {
            BinaryOperator::Add => "+",
            BinaryOperator::Subtract => "-",
            BinaryOperator::Multiply => "*",
            BinaryOperator::Divide => "/",
            _ => "**",
        };
        Err(problem(
            "expression/not-finite",
            format!("{} {sign} {} is not a finite number", number_text(x), number_text(y)),
        ))
    }
}

/// Column-major matrix product; the shapes fit.
pub(crate) fn matrix_product(a: &Array, b: &Array) -> Array {
    let mut values = Vec::with_capacity(a.rows * b.columns);
    for column in b.values.chunks_exact(b.rows.max(1)) {
        for row in 0..a.rows {
            values.push(column.iter().enumerate().map(|(k, y)| a.values[k * a.rows + row] * y).sum());
        }
    }
    Array { rows: a.rows, columns: b.columns, values }
}

fn equal(a: &Value, b: &Value, scope: &Scope) -> Outcome<bool> {
    let object = |v: &Value| crate::object_of(v, scope);
    Ok(match (a, b) {
        (Value::Text(a), Value::Text(b)) => a == b,
        (Value::Nothing, Value::Nothing) => true,
        (Value::Nothing, Value::Objects(list)) | (Value::Objects(list), Value::Nothing) => list.is_empty(),
        (Value::Nothing, other) | (other, Value::Nothing) => {
            matches!(other, Value::Text(t) if t.eq_ignore_ascii_case("none") || t.is_empty())
        }
        (Value::Object(_) | Value::Objects(_), _) | (_, Value::Object(_) | Value::Objects(_)) => {
            a == b || object(a).is_some() && object(a) == object(b)
        }
        (Value::Array(x), Value::Array(y)) => x == y,
        (Value::Texts(x), Value::Texts(y)) => x == y,
        _ => number(a)? == number(b)?,
    })
}

/// A value as text, as `//` joins it: objects by full name, numbers in the shortest form that
/// reads back.
pub(crate) fn text_of(value: &Value, scope: &Scope) -> Outcome<String> {
    Ok(match value {
        Value::Text(text) => text.clone(),
        Value::Integer(i) => i.to_string(),
        Value::Number(x) => number_text(*x),
        Value::Flag(b) => i32::from(*b).to_string(),
        Value::Object(id) if scope.database.get(*id).is_some() => scope.database.full_name(*id),
        Value::Nothing => "NONE".to_string(),
        Value::Array(array) if array.values.len() == 1 => number_text(array.values[0]),
        Value::Texts(list) if list.len() == 1 => list[0].clone(),
        Value::Objects(list) if list.len() == 1 => text_of(&Value::Object(list[0]), scope)?,
        Value::Function(function) => function.write(|id| scope.database.full_name(id)),
        other => {
            return Err(problem("expression/not-a-text", format!("a text is needed here, not {}", describe(other))));
        }
    })
}
