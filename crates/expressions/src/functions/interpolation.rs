//! Curves through points and polynomials.

use model::Value;

use super::{Arguments, Function, column, function, real};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function("INTERP1", "x, y, at, [method]", "values of a curve between its points", interp1),
    function("POLYFIT", "x, y, order", "coefficients of the polynomial of least squares, from power 0 up", polyfit),
    function("POLYVAL", "coefficients, x", "value of a polynomial", |a| {
        let coefficients = a.numbers(0)?;
        let at = |x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        match &a.values[1] {
            Value::Array(xs) => column(xs.values.iter().map(|x| at(*x)).collect()),
            _ => real(at(a.number(1)?)),
        }
    }),
    function("VALAT", "x, y, at", "value of a polyline at x", |a| {
        let (x, y) = curve(a)?;
        let at = a.number(2)?;
        real(linear(&x, &y, at))
    }),
];

/// The points of a curve, x rising, from the first two arguments.
pub(super) fn curve(a: &Arguments) -> Outcome<(Vec<f64>, Vec<f64>)> {
    checked_curve(a, a.numbers(0)?, a.numbers(1)?)
}

/// Refuses what is no curve.
pub(super) fn checked_curve(a: &Arguments, x: Vec<f64>, y: Vec<f64>) -> Outcome<(Vec<f64>, Vec<f64>)> {
    if x.len() != y.len() || x.len() < 2 {
        return Err(a.error(format!("{} x values and {} y values make no curve", x.len(), y.len())));
    }
    if x.windows(2).any(|w| w[0] >= w[1]) {
        return Err(a.error("the x values must rise"));
    }
    Ok((x, y))
}

/// Index of the piece in which x lies; the end pieces reach outwards.
pub(super) fn piece(x: &[f64], at: f64) -> usize {
    x.partition_point(|p| *p <= at).clamp(1, x.len() - 1) - 1
}

pub(super) fn linear(x: &[f64], y: &[f64], at: f64) -> f64 {
    let i = piece(x, at);
    y[i] + (y[i + 1] - y[i]) * (at - x[i]) / (x[i + 1] - x[i])
}

/// Cubic between two points with given slopes.
pub(super) fn hermite(x: &[f64], y: &[f64], slopes: &[f64], at: f64) -> f64 {
    let i = piece(x, at);
    let h = x[i + 1] - x[i];
    let s = (at - x[i]) / h;
    let (a, b) = (1.0 - s, s);
    y[i] * a * a * (1.0 + 2.0 * s)
        + y[i + 1] * b * b * (3.0 - 2.0 * s)
        + h * (slopes[i] * a * a * s - slopes[i + 1] * b * b * a)
}

fn interp1(a: &mut Arguments) -> Outcome<Value> {
    let (x, y) = curve(a)?;
    let method = if a.len() > 3 { a.text(3)?.to_ascii_lowercase() } else { "linear".to_string() };
    let slopes = match method.as_str() {
        "nearest" | "linear" => Vec::new(),
        "spline" => spline_slopes(&x, &y),
        "pchip" | "cubic" => pchip_slopes(&x, &y),
        other => {
            return Err(a.error(format!(
                "the method must be \"nearest\", \"linear\", \"spline\", \"pchip\" or \"cubic\", not \"{other}\""
            )));
        }
    };
    let points = a.numbers(2)?;
    if slopes.is_empty()
        && let Some(out) = points.iter().find(|p| **p < x[0] || **p > x[x.len() - 1])
    {
        return Err(a.error(format!("{} lies outside the curve", crate::print::number_text(*out))));
    }
    let at = |p: f64| match method.as_str() {
        "nearest" => {
            let i = piece(&x, p);
            if p - x[i] < x[i + 1] - p { y[i] } else { y[i + 1] }
        }
        "linear" => linear(&x, &y, p),
        _ => hermite(&x, &y, &slopes, p),
    };
    match &a.values[2] {
        Value::Array(_) => column(points.into_iter().map(at).collect()),
        _ => real(at(points[0])),
    }
}

/// Slopes of the cubic spline whose third derivative is continuous at the second and the last but
/// one point (not-a-knot).
pub(super) fn spline_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let d: Vec<f64> = (0..n - 1).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    if n == 2 {
        return vec![d[0]; 2];
    }
    if n == 3 {
        // One parabola through the three points.
        let c = (d[1] - d[0]) / (x[2] - x[0]);
        return vec![d[0] - c * h[0], d[0] + c * h[0], d[1] + c * h[1]];
    }
    // Tridiagonal system for the slopes; the end rows carry the not-a-knot conditions.
    let (mut lower, mut main, mut upper, mut right) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    main[0] = h[1];
    upper[0] = h[0] + h[1];
    right[0] = ((h[0] + 2.0 * upper[0]) * h[1] * d[0] + h[0] * h[0] * d[1]) / upper[0];
    for i in 1..n - 1 {
        lower[i] = h[i];
        main[i] = 2.0 * (h[i - 1] + h[i]);
        upper[i] = h[i - 1];
        right[i] = 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
    }
    let (p, q) = (h[n - 2], h[n - 3]);
    main[n - 1] = q;
    lower[n - 1] = p + q;
    right[n - 1] = (p * p * d[n - 3] + (2.0 * (p + q) + p) * q * d[n - 2]) / (p + q);
    for i in 1..n {
        let factor = lower[i] / main[i - 1];
        main[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    let mut slopes = vec![0.0; n];
    slopes[n - 1] = right[n - 1] / main[n - 1];
    for i in (0..n - 1).rev() {
        slopes[i] = (right[i] - upper[i] * slopes[i + 1]) / main[i];
    }
    slopes
}

/// Slopes that keep the curve monotonic between its points (Fritsch and Butland).
pub(super) fn pchip_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let d: Vec<f64> = (0..n - 1).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    if n == 2 {
        return vec![d[0]; 2];
    }
    let end = |h0: f64, h1: f64, d0: f64, d1: f64| {
        let slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
        if slope * d0 <= 0.0 {
            0.0
        } else if d0 * d1 <= 0.0 && slope.abs() > 3.0 * d0.abs() {
            3.0 * d0
        } else {
            slope
        }
    };
    let mut slopes = vec![end(h[0], h[1], d[0], d[1])];
    for i in 1..n - 1 {
        let (w1, w2) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
        slopes.push(if d[i - 1] * d[i] <= 0.0 { 0.0 } else { (w1 + w2) / (w1 / d[i - 1] + w2 / d[i]) });
    }
    slopes.push(end(h[n - 2], h[n - 3], d[n - 2], d[n - 3]));
    slopes
}

/// Coefficients from power 0 up, by least squares with Householder reflections on x scaled to its
/// range.
fn polyfit(a: &mut Arguments) -> Outcome<Value> {
    let (x, mut y, order) = (a.numbers(0)?, a.numbers(1)?, a.count(2)?);
    let (m, n) = (x.len(), order + 1);
    if y.len() != m || m < n || n > 60 {
        return Err(a.error(format!(
            "{} x and {} y values do not determine a polynomial of order {order}",
            m,
            y.len()
        )));
    }
    let size = x.iter().fold(0.0_f64, |s, x| s.max(x.abs())).max(f64::MIN_POSITIVE);
    let mut columns: Vec<Vec<f64>> = (0..n).map(|k| x.iter().map(|x| (x / size).powi(k as i32)).collect()).collect();
    for k in 0..n {
        let (done, rest) = columns.split_at_mut(k + 1);
        let pivot = &mut done[k];
        let length = pivot[k..].iter().map(|v| v * v).sum::<f64>().sqrt();
        if length <= 1e-13 {
            return Err(a.error("there are too few different x values"));
        }
        let diagonal = if pivot[k] > 0.0 { -length } else { length };
        let mut mirror: Vec<f64> = pivot[k..].to_vec();
        mirror[0] -= diagonal;
        let scale = 2.0 / mirror.iter().map(|v| v * v).sum::<f64>();
        for target in rest.iter_mut().map(|c| &mut c[k..]).chain(std::iter::once(&mut y[k..])) {
            let dot: f64 = mirror.iter().zip(target.iter()).map(|(u, v)| u * v).sum();
            for (v, u) in target.iter_mut().zip(&mirror) {
                *v -= scale * dot * u;
            }
        }
        pivot[k] = diagonal;
    }
    let mut coefficients = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| columns[j][k] * coefficients[j]).sum();
        coefficients[k] = (y[k] - known) / columns[k][k];
    }
    column(coefficients.iter().enumerate().map(|(k, c)| c / size.powi(k as i32)).collect())
}
