//! Curves through points: evaluated at equal steps, differentiated, integrated. A curve is a matrix
//! of two rows (x above y) or two arrays.

use model::{Array, Value};

use super::{
    Arguments, Function, column, function,
    interpolation::{checked_curve, curve, hermite, linear, pchip_slopes, piece, spline_slopes},
};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function("AKIMA_SPLINE", "x, y, n", "n values of an Akima curve through points", |a| sampled(a, Kind::Akima)),
    function(
        "AKIMA_SPLINE2",
        "x, y, other_x, flag",
        "Akima curve where two ranges of x overlap, at the steps of the first (1) or second (0)",
        akima_overlap,
    ),
    function("CSPLINE", "x, y, n", "n values of the natural cubic spline through points", |a| {
        sampled(a, Kind::Natural)
    }),
    function("CUBIC_SPLINE", "x, y, n", "n values of parabolas through three points each", |a| {
        sampled(a, Kind::Lagrange)
    }),
    function("DETREND", "x, y", "y without its straight line of least squares", detrend),
    function("DIFFERENTIATE", "curve", "slopes of a cubic spline at the points of a curve", |a| {
        let (x, y) = both_rows(a)?;
        let slopes = fitted_slopes(&x, &y);
        two_rows(&x, &slopes)
    }),
    function("HERMITE_SPLINE", "x, y, n", "n values of a curve that overshoots no point", |a| {
        sampled(a, Kind::Hermite)
    }),
    function("INTEGR", "x, y", "integral of a cubic spline up to each point", |a| {
        let (x, y) = curve(a)?;
        column(integrals(&x, &y))
    }),
    function("INTEGRATE", "curve", "integral of a cubic spline up to each point of a curve", |a| {
        let (x, y) = both_rows(a)?;
        let sums = integrals(&x, &y);
        two_rows(&x, &sums)
    }),
    function("LINEAR_SPLINE", "x, y, n", "n values of the polyline through points", |a| sampled(a, Kind::Linear)),
    function("NOTAKNOT_SPLINE", "x, y, n", "n values of the not-a-knot cubic spline", |a| sampled(a, Kind::NotAKnot)),
    function("RESAMPLE", "curve, x, kind, n", "values at x of a curve smoothed by a spline of n points", |a| {
        let ((x, y), at, kind, n) = (both_rows(a)?, a.numbers(1)?, kind(a, 2)?, points(a, 3)?);
        let curve = Curve::through(x, y, kind);
        let (xs, ys) = (curve.steps(n), curve.values(n));
        column(at.into_iter().map(|t| linear(&xs, &ys, t)).collect())
    }),
    function(
        "SPLINE",
        "curve, kind, n",
        "n points of a spline: AKIMA, CSPLINE, CUBIC, LINEAR, NOTAKNOT, HERMITE",
        |a| {
            let ((x, y), kind, n) = (both_rows(a)?, kind(a, 1)?, points(a, 2)?);
            let curve = Curve::through(x, y, kind);
            two_rows(&curve.steps(n), &curve.values(n))
        },
    ),
    function("UNWRAP", "angles", "angles in degrees without jumps above 180", |a| {
        let array = a.array(0)?;
        let (mut turns, mut last) = (0.0, None);
        let mut values = Vec::with_capacity(array.values.len());
        for x in array.values {
            if let Some(last) = last {
                let jump: f64 = x - last;
                if jump.abs() > 180.0 {
                    // Half a turn stays on the side of the jump.
                    turns -= ((jump.abs() - 180.0) / 360.0).ceil().copysign(jump);
                }
            }
            last = Some(x);
            values.push(x + 360.0 * turns);
        }
        Ok(Value::Array(Array { values, ..Array { rows: array.rows, columns: array.columns, values: Vec::new() } }))
    }),
];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Akima,
    Natural,
    Lagrange,
    Linear,
    NotAKnot,
    Hermite,
}

fn kind(a: &Arguments, i: usize) -> Outcome<Kind> {
    let word = a.text(i)?;
    Ok(match word.trim().to_ascii_uppercase().as_str() {
        "AKIMA" => Kind::Akima,
        "CSPLINE" => Kind::Natural,
        "CUBIC" => Kind::Lagrange,
        "LINEAR" => Kind::Linear,
        "NOTAKNOT" => Kind::NotAKnot,
        "HERMITE" => Kind::Hermite,
        _ => {
            return Err(
                a.error(format!("the spline is AKIMA, CSPLINE, CUBIC, LINEAR, NOTAKNOT or HERMITE, not \"{word}\""))
            );
        }
    })
}

fn points(a: &Arguments, i: usize) -> Outcome<usize> {
    let n = a.count(i)?;
    if n < 2 { Err(a.error("at least two output values are needed")) } else { Ok(n) }
}

/// The rows of a 2 x n matrix.
fn both_rows(a: &Arguments) -> Outcome<(Vec<f64>, Vec<f64>)> {
    let m = a.array(0)?;
    if m.rows != 2 {
        return Err(a.error(format!("a curve is a 2 x n matrix, not {} x {}", m.rows, m.columns)));
    }
    let (x, y) = m.values.chunks_exact(2).map(|p| (p[0], p[1])).unzip();
    checked_curve(a, x, y)
}

fn two_rows(x: &[f64], y: &[f64]) -> Outcome<Value> {
    let values: Vec<f64> = x.iter().zip(y).flat_map(|(x, y)| [*x, *y]).collect();
    Ok(Value::Array(Array { rows: 2, columns: x.len(), values }))
}

struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
    kind: Kind,
    slopes: Vec<f64>,
}

impl Curve {
    /// A curve through points whose x rise.
    fn through(x: Vec<f64>, y: Vec<f64>, kind: Kind) -> Curve {
        let slopes = match kind {
            Kind::Akima => akima_slopes(&x, &y),
            Kind::Natural => natural_slopes(&x, &y),
            Kind::NotAKnot => spline_slopes(&x, &y),
            Kind::Hermite => pchip_slopes(&x, &y),
            Kind::Lagrange | Kind::Linear => Vec::new(),
        };
        Curve { x, y, kind, slopes }
    }

    fn at(&self, t: f64) -> f64 {
        match self.kind {
            Kind::Linear => linear(&self.x, &self.y, t),
            Kind::Lagrange => parabola(&self.x, &self.y, t),
            _ => hermite(&self.x, &self.y, &self.slopes, t),
        }
    }

    /// n values of x at equal steps from end to end.
    fn steps(&self, n: usize) -> Vec<f64> {
        let (first, last) = (self.x[0], self.x[self.x.len() - 1]);
        let step = (last - first) / (n.max(2) - 1) as f64;
        (0..n).map(|i| if i + 1 == n { last } else { first + step * i as f64 }).collect()
    }

    fn values(&self, n: usize) -> Vec<f64> {
        self.steps(n).into_iter().map(|t| self.at(t)).collect()
    }
}

fn sampled(a: &mut Arguments, kind: Kind) -> Outcome<Value> {
    let (x, y) = curve(a)?;
    let n = points(a, 2)?;
    column(Curve::through(x, y, kind).values(n))
}

fn akima_overlap(a: &mut Arguments) -> Outcome<Value> {
    let (x, y) = curve(a)?;
    let (other, flag) = (a.numbers(2)?, a.integer(3)?);
    if other.len() < 2 || other.windows(2).any(|w| w[0] >= w[1]) {
        return Err(a.error("the second x values must rise"));
    }
    let (start, end) = (x[0].max(other[0]), x[x.len() - 1].min(other[other.len() - 1]));
    if start > end {
        return Err(a.error("the two ranges of x do not overlap"));
    }
    let steps = if flag == 0 { &other } else { &x };
    let step = steps[1] - steps[0];
    let n = ((end - start) / step * (1.0 + 1e-12)).floor();
    if n > 1e7 {
        return Err(a.error("the step is too small for the range"));
    }
    let curve = Curve::through(x, y, Kind::Akima);
    column((0..=n as usize).map(|i| curve.at((start + step * i as f64).min(end))).collect())
}

/// The parabola through the ends of the piece and the point before it, or behind the first piece.
fn parabola(x: &[f64], y: &[f64], t: f64) -> f64 {
    if x.len() < 3 {
        return linear(x, y, t);
    }
    let i = piece(x, t).max(1) - 1;
    let (a, b, c) = (x[i], x[i + 1], x[i + 2]);
    y[i] * (t - b) * (t - c) / ((a - b) * (a - c))
        + y[i + 1] * (t - a) * (t - c) / ((b - a) * (b - c))
        + y[i + 2] * (t - a) * (t - b) / ((c - a) * (c - b))
}

fn chords(x: &[f64], y: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let d = h.iter().zip(y.windows(2)).map(|(h, w)| (w[1] - w[0]) / h).collect();
    (h, d)
}

/// Akima, Journal of the ACM 17 (1970): the slope at a point leans to the side where the chords
/// change less. Two chords continue each end by a parabola.
fn akima_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let (_, d) = chords(x, y);
    let Some((first, last)) = d.first().zip(d.last()) else { return vec![0.0; x.len()] };
    let second = d.get(1).unwrap_or(first);
    let before = d.len().checked_sub(2).and_then(|i| d.get(i)).unwrap_or(last);
    let mut m = vec![3.0 * first - 2.0 * second, 2.0 * first - second];
    m.extend(&d);
    m.extend([2.0 * last - before, 3.0 * last - 2.0 * before]);
    let largest = m.windows(2).fold(0.0_f64, |s, w| s.max((w[1] - w[0]).abs()));
    m.windows(4)
        .map(|w| {
            let (left, right) = ((w[1] - w[0]).abs(), (w[3] - w[2]).abs());
            // Straight on both sides: neither chord leads.
            if left + right <= 1e-9 * largest {
                f64::midpoint(w[1], w[2])
            } else {
                (right * w[1] + left * w[2]) / (left + right)
            }
        })
        .collect()
}

/// Slopes of a cubic spline from its second derivatives.
fn slopes_of(x: &[f64], y: &[f64], second: &[f64]) -> Vec<f64> {
    let (h, d) = chords(x, y);
    let n = h.len();
    let mut slopes: Vec<f64> = (0..n).map(|i| d[i] - h[i] * (2.0 * second[i] + second[i + 1]) / 6.0).collect();
    slopes.push(d[n - 1] + h[n - 1] * (second[n - 1] + 2.0 * second[n]) / 6.0);
    slopes
}

/// Second derivatives of a cubic spline: `first` and `last` are the rows [main, side, right] of the
/// end conditions.
fn second_derivatives(x: &[f64], y: &[f64], first: [f64; 3], last: [f64; 3]) -> Vec<f64> {
    let (h, d) = chords(x, y);
    let n = x.len();
    let (mut lower, mut main, mut upper, mut right) = (vec![0.0; n], vec![1.0; n], vec![0.0; n], vec![0.0; n]);
    [main[0], upper[0], right[0]] = first;
    for i in 1..n - 1 {
        lower[i] = h[i - 1];
        main[i] = 2.0 * (h[i - 1] + h[i]);
        upper[i] = h[i];
        right[i] = 6.0 * (d[i] - d[i - 1]);
    }
    [main[n - 1], lower[n - 1], right[n - 1]] = last;
    for i in 1..n {
        let factor = lower[i] / main[i - 1];
        main[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    for i in (0..n).rev() {
        let above = if i + 1 < n { upper[i] * right[i + 1] } else { 0.0 };
        right[i] = (right[i] - above) / main[i];
    }
    right
}

/// The curvature vanishes at both ends.
fn natural_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    slopes_of(x, y, &second_derivatives(x, y, [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]))
}

/// Second derivatives of the spline of Forsythe, Malcolm and Moler (1977): the third derivative at
/// an end is that of the cubic through the four points there.
fn fitted(x: &[f64], y: &[f64]) -> Vec<f64> {
    let (h, d) = chords(x, y);
    let n = x.len();
    if n < 3 {
        return vec![0.0; n];
    }
    if n == 3 {
        return vec![2.0 * (d[1] - d[0]) / (x[2] - x[0]); 3];
    }
    let third = |i: usize| {
        let bend = |k: usize| (d[k + 1] - d[k]) / (x[k + 2] - x[k]);
        6.0 * (bend(i + 1) - bend(i)) / (x[i + 3] - x[i])
    };
    second_derivatives(x, y, [-1.0, 1.0, third(0) * h[0]], [1.0, -1.0, third(n - 4) * h[n - 2]])
}

fn fitted_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    slopes_of(x, y, &fitted(x, y))
}

fn integrals(x: &[f64], y: &[f64]) -> Vec<f64> {
    let second = fitted(x, y);
    let mut sum = 0.0;
    let mut sums = vec![0.0];
    for i in 1..x.len() {
        let h = x[i] - x[i - 1];
        sum += h * (y[i - 1] + y[i]) / 2.0 - h.powi(3) * (second[i - 1] + second[i]) / 24.0;
        sums.push(sum);
    }
    sums
}

fn detrend(a: &mut Arguments) -> Outcome<Value> {
    let (x, y) = (a.numbers(0)?, a.numbers(1)?);
    if x.len() != y.len() || x.is_empty() {
        return Err(a.error(format!("{} x values and {} y values make no curve", x.len(), y.len())));
    }
    let n = x.len() as f64;
    let (mx, my) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let xx: f64 = x.iter().map(|x| (x - mx).powi(2)).sum();
    let xy: f64 = x.iter().zip(&y).map(|(x, y)| (x - mx) * (y - my)).sum();
    let slope = if xx == 0.0 { 0.0 } else { xy / xx };
    column(x.iter().zip(&y).map(|(x, y)| y - my - slope * (x - mx)).collect())
}
