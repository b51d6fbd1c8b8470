//! Functions of numbers. Where one argument is wanted, an array is taken element by element.
//! Angles of SIN, ATAN and the like are in the current angle unit.

use model::{Array, Value};

use super::{Arguments, Function, function, real};
use crate::{print::number_text, scope::Outcome};

pub const TABLE: &[Function] = &[
    super::EVAL,
    function("ABS", "x", "absolute value", |a| match a.values[0] {
        Value::Integer(i) if i != i64::MIN => Ok(Value::Integer(i.abs())),
        _ => each(a, f64::abs),
    }),
    function("ACOS", "x", "arc cosine in the current angle unit", |a| arc(a, f64::acos)),
    function("AINT", "x", "nearest whole number towards zero, as a real", |a| each(a, f64::trunc)),
    function("ANINT", "x", "nearest whole number, as a real", |a| each(a, f64::round)),
    function("ASIN", "x", "arc sine in the current angle unit", |a| arc(a, f64::asin)),
    function("ATAN", "x", "arc tangent in the current angle unit", |a| {
        let unit = a.angle_unit();
        each(a, |x| x.atan() / unit)
    }),
    function("ATAN2", "y, x", "angle of the point x, y in the current angle unit", |a| {
        real(a.number(0)?.atan2(a.number(1)?) / a.angle_unit())
    }),
    function("CEIL", "x", "smallest whole number not below x", |a| each(a, f64::ceil)),
    function("COS", "angle", "cosine of an angle", |a| {
        let unit = a.angle_unit();
        each(a, |x| (x * unit).cos())
    }),
    function("COSH", "x", "hyperbolic cosine", |a| each(a, f64::cosh)),
    function("DIM", "x, y", "x - y, or zero where y is larger", |a| real((a.number(0)? - a.number(1)?).max(0.0))),
    function("EXP", "x", "e to the power x", |a| each(a, f64::exp)),
    function("FLOOR", "x", "largest whole number not above x", |a| each(a, f64::floor)),
    function("IF", "x, negative, zero, positive", "one of three values, chosen by the sign of x", if_sign),
    function("INT", "x", "whole part of x, as an integer", |a| whole(a, f64::trunc)),
    function("LOG", "x", "natural logarithm", |a| positive(a, f64::ln)),
    function("LOG10", "x", "logarithm to base 10", |a| positive(a, f64::log10)),
    function("MAG", "x, y, z", "length of a vector", |a| {
        real(glam::DVec3::new(a.number(0)?, a.number(1)?, a.number(2)?).length())
    }),
    function("MOD", "x, y", "remainder of x / y, with the sign of x", modulus),
    function("NINT", "x", "nearest integer", |a| whole(a, f64::round)),
    function("RTOI", "x", "real to integer, towards zero", |a| whole(a, f64::trunc)),
    function("SIGN", "size, sign", "the size of one number with the sign of another", |a| {
        let (size, sign) = (a.number(0)?.abs(), a.number(1)?);
        real(if sign < 0.0 { -size } else { size })
    }),
    function("SIN", "angle", "sine of an angle", |a| {
        let unit = a.angle_unit();
        each(a, |x| (x * unit).sin())
    }),
    function("SINH", "x", "hyperbolic sine", |a| each(a, f64::sinh)),
    function("SQRT", "x", "square root", |a| {
        checked(a, |x| *x >= 0.0, "a negative number has no square root")?;
        each(a, f64::sqrt)
    }),
    function("STEP", "x, x0, h0, x1, h1", "smooth cubic step from h0 at x0 to h1 at x1", step),
    function("TAN", "angle", "tangent of an angle", |a| {
        let unit = a.angle_unit();
        each(a, |x| (x * unit).tan())
    }),
    function("TANH", "x", "hyperbolic tangent", |a| each(a, f64::tanh)),
];

fn each(a: &Arguments, f: impl Fn(f64) -> f64) -> Outcome<Value> {
    match &a.values[0] {
        Value::Array(array) => {
            Ok(Value::Array(Array { values: array.values.iter().map(|x| f(*x)).collect(), ..array.clone() }))
        }
        _ => real(f(a.number(0)?)),
    }
}

fn checked(a: &Arguments, fine: impl Fn(&f64) -> bool, trouble: &str) -> Outcome<()> {
    match a.numbers(0)?.iter().find(|x| !fine(x)) {
        Some(x) => Err(a.error(format!("{trouble} ({})", number_text(*x)))),
        None => Ok(()),
    }
}

fn arc(a: &Arguments, f: impl Fn(f64) -> f64) -> Outcome<Value> {
    checked(a, |x| x.abs() <= 1.0, "the argument must lie between -1 and 1")?;
    let unit = a.angle_unit();
    each(a, |x| f(x) / unit)
}

fn positive(a: &Arguments, f: impl Fn(f64) -> f64) -> Outcome<Value> {
    checked(a, |x| *x > 0.0, "the argument must be above 0")?;
    each(a, f)
}

/// An integer.
fn whole(a: &Arguments, f: impl Fn(f64) -> f64) -> Outcome<Value> {
    if let Value::Array(_) = a.values[0] {
        return each(a, f);
    }
    let x = f(a.number(0)?);
    if x.abs() < 9.0e15 { Ok(Value::Integer(x as i64)) } else { Err(a.error("the number is too large for an integer")) }
}

fn if_sign(a: &mut Arguments) -> Outcome<Value> {
    let x = a.number(0)?;
    let chosen = if x < 0.0 {
        1
    } else if x == 0.0 {
        2
    } else {
        3
    };
    Ok(a.values[chosen].clone())
}

/// The remainder takes the sign of the first argument.
fn modulus(a: &mut Arguments) -> Outcome<Value> {
    if a.number(1)? == 0.0 {
        return Err(a.error("the second argument is zero"));
    }
    if let (Value::Integer(x), Value::Integer(y)) = (&a.values[0], &a.values[1]) {
        return Ok(Value::Integer(x.wrapping_rem(*y)));
    }
    real(a.number(0)? % a.number(1)?)
}

/// Cubic step from h0 at x0 to h1 at x1.
fn step(a: &mut Arguments) -> Outcome<Value> {
    let (x0, h0, x1, h1) = (a.number(1)?, a.number(2)?, a.number(3)?, a.number(4)?);
    if x0 == x1 {
        return Err(a.error("the step begins and ends at the same x"));
    }
    each(a, |x| {
        let s = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
        h0 + (h1 - h0) * s * s * (3.0 - 2.0 * s)
    })
}
