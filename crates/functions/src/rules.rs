//! Values and derivatives of the basic operations.
//!
//! Derivatives are one-sided where a function has a kink. Where a derivative is infinite (`SQRT` at
//! 0) it is taken as 0, as Adams does for `DM` at coincident markers: an infinite entry would only
//! destroy the whole Newton matrix.

use crate::tape::{Binary, Unary};

/// Square roots of numbers above this are taken as 0: rounding of what is 0 on paper.
const SLIGHTLY_NEGATIVE: f64 = -1e-12;

fn square_root(x: f64) -> f64 {
    if x > SLIGHTLY_NEGATIVE && x < 0.0 { 0.0 } else { x.sqrt() }
}

fn power(x: f64, p: f64) -> f64 {
    if p == 2.0 { x * x } else { x.powf(p) }
}

/// A singular derivative counts as 0.
fn finite(x: f64) -> f64 {
    if x.is_infinite() { 0.0 } else { x }
}

pub(crate) fn unary(kind: Unary, x: f64) -> f64 {
    match kind {
        Unary::Negate => -x,
        Unary::Abs => x.abs(),
        Unary::Sqrt => square_root(x),
        Unary::Exp => x.exp(),
        Unary::Log => x.ln(),
        Unary::Log10 => x.log10(),
        Unary::Sin => x.sin(),
        Unary::Cos => x.cos(),
        Unary::Tan => x.tan(),
        Unary::Asin => x.asin(),
        Unary::Acos => x.acos(),
        Unary::Atan => x.atan(),
        Unary::Sinh => x.sinh(),
        Unary::Cosh => x.cosh(),
        Unary::Tanh => x.tanh(),
        Unary::Truncate => x.trunc(),
        Unary::Round => x.round(),
    }
}

pub(crate) fn binary(kind: Binary, x: f64, y: f64) -> f64 {
    match kind {
        Binary::Add => x + y,
        Binary::Subtract => x - y,
        Binary::Multiply => x * y,
        Binary::Divide => x / y,
        Binary::Power => power(x, y),
        Binary::Atan2 => x.atan2(y),
    }
}

/// First derivative; `f` is the value at `x`.
pub(crate) fn unary_slope(kind: Unary, x: f64, f: f64) -> f64 {
    match kind {
        Unary::Negate => -1.0,
        Unary::Abs => {
            if x < 0.0 {
                -1.0
            } else {
                1.0
            }
        }
        Unary::Sqrt => finite(0.5 / f),
        Unary::Exp => f,
        Unary::Log => 1.0 / x,
        Unary::Log10 => std::f64::consts::LOG10_E / x,
        Unary::Sin => x.cos(),
        Unary::Cos => -x.sin(),
        Unary::Tan => 1.0 + f * f,
        Unary::Asin => finite(1.0 / (1.0 - x * x).sqrt()),
        Unary::Acos => finite(-1.0 / (1.0 - x * x).sqrt()),
        Unary::Atan => 1.0 / (1.0 + x * x),
        Unary::Sinh => x.cosh(),
        Unary::Cosh => x.sinh(),
        Unary::Tanh => 1.0 - f * f,
        Unary::Truncate | Unary::Round => 0.0,
    }
}

/// Second derivative; `f` is the value at `x`.
pub(crate) fn unary_curvature(kind: Unary, x: f64, f: f64) -> f64 {
    match kind {
        Unary::Negate | Unary::Abs | Unary::Truncate | Unary::Round => 0.0,
        Unary::Sqrt => finite(-0.25 / (f * f * f)),
        Unary::Exp | Unary::Sinh | Unary::Cosh => f,
        Unary::Log => -1.0 / (x * x),
        Unary::Log10 => -std::f64::consts::LOG10_E / (x * x),
        Unary::Sin | Unary::Cos => -f,
        Unary::Tan => 2.0 * f * (1.0 + f * f),
        Unary::Asin => finite(x * (1.0 - x * x).powf(-1.5)),
        Unary::Acos => finite(-x * (1.0 - x * x).powf(-1.5)),
        Unary::Atan => -2.0 * x / (1.0 + x * x).powi(2),
        Unary::Tanh => -2.0 * f * (1.0 - f * f),
    }
}

/// First derivatives with respect to both arguments.
pub(crate) fn binary_slopes(kind: Binary, x: f64, y: f64, f: f64) -> (f64, f64) {
    match kind {
        Binary::Add => (1.0, 1.0),
        Binary::Subtract => (1.0, -1.0),
        Binary::Multiply => (y, x),
        Binary::Divide => (1.0 / y, -f / y),
        Binary::Power => (power_slope(x, y), exponent_slope(x, f)),
        Binary::Atan2 => {
            let square = x * x + y * y;
            if square == 0.0 { (0.0, 0.0) } else { (y / square, -x / square) }
        }
    }
}

/// Second derivatives: xx, xy, yy.
pub(crate) fn binary_curvatures(kind: Binary, x: f64, y: f64, f: f64) -> (f64, f64, f64) {
    match kind {
        Binary::Add | Binary::Subtract => (0.0, 0.0, 0.0),
        Binary::Multiply => (0.0, 1.0, 0.0),
        Binary::Divide => (0.0, -1.0 / (y * y), 2.0 * f / (y * y)),
        Binary::Power => {
            let xx = if y == 0.0 || y == 1.0 { 0.0 } else { finite(y * (y - 1.0) * power(x, y - 2.0)) };
            if x > 0.0 {
                let log = x.ln();
                (xx, power(x, y - 1.0) * (1.0 + y * log), f * log * log)
            } else {
                (xx, 0.0, 0.0)
            }
        }
        Binary::Atan2 => {
            let square = x * x + y * y;
            if square == 0.0 {
                (0.0, 0.0, 0.0)
            } else {
                let xx = -2.0 * x * y / (square * square);
                (xx, (x * x - y * y) / (square * square), -xx)
            }
        }
    }
}

fn power_slope(x: f64, p: f64) -> f64 {
    if p == 0.0 { 0.0 } else { finite(p * power(x, p - 1.0)) }
}

/// d(x**p)/dp. Below and at 0 the power is defined for single exponents only: no derivative.
fn exponent_slope(x: f64, f: f64) -> f64 {
    if x > 0.0 { f * x.ln() } else { 0.0 }
}
