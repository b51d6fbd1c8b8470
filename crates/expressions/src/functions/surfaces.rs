//! Surfaces over grids and over scattered points, and periodic curves.

use model::{Array, Value};

use super::{
    Arguments, Function, column, function,
    interpolation::{checked_curve, hermite, linear, piece, spline_slopes},
};
use crate::{print::number_text, scope::Outcome};

pub const TABLE: &[Function] = &[
    function("GRIDDATA", "x, y, z, at_x, at_y", "heights between scattered points, on triangles", griddata),
    function(
        "INTERP2",
        "x, y, z, at_x, at_y, [method]",
        "values of a surface over a grid: nearest, linear, spline, cubic",
        interp2,
    ),
    function("INTERPFT", "values, n", "n values of a periodic curve at equal steps", interpft),
    function("MESHGRID", "x, y, which", "x (0) or y (1) coordinates of a grid", |a| {
        let (x, y, which) = (a.numbers(0)?, a.numbers(1)?, a.integer(2)?);
        sized(a, x.len(), y.len())?;
        let values = x.iter().flat_map(|x| y.iter().map(move |y| if which == 0 { *x } else { *y })).collect();
        Ok(Value::Array(Array { rows: y.len(), columns: x.len(), values }))
    }),
];

fn sized(a: &Arguments, n: usize, m: usize) -> Outcome<()> {
    if n.saturating_mul(m) <= 10_000_000 { Ok(()) } else { Err(a.error("the result would be too large")) }
}

/// The curve through equally spaced values of one period with no more waves than they can carry.
fn interpft(a: &mut Arguments) -> Outcome<Value> {
    let (values, n) = (a.numbers(0)?, a.count(1)?);
    let m = values.len();
    if m == 0 || n == 0 {
        return Err(a.error("values and their number are needed"));
    }
    sized(a, m, n)?;
    let period = m as f64;
    let kernel = |t: f64| {
        let angle = std::f64::consts::PI * t;
        if (t / period).fract() == 0.0 {
            1.0
        } else if m.is_multiple_of(2) {
            angle.sin() / (period * (angle / period).tan())
        } else {
            angle.sin() / (period * (angle / period).sin())
        }
    };
    column(
        (0..n)
            .map(|j| {
                let t = j as f64 * period / n as f64;
                values.iter().enumerate().map(|(k, v)| v * kernel(t - k as f64)).sum()
            })
            .collect(),
    )
}

/// One direction of a surface.
fn along(method: &str, x: &[f64], y: &[f64], t: f64) -> f64 {
    match method {
        "nearest" => {
            let i = piece(x, t);
            if t - x[i] < x[i + 1] - t { y[i] } else { y[i + 1] }
        }
        "linear" => linear(x, y, t),
        "spline" => hermite(x, y, &spline_slopes(x, y), t),
        _ => {
            // Cubic convolution (Keys 1981): slopes from neighbours, a cubic continues the ends.
            let n = x.len();
            let h = x[1] - x[0];
            let value = |i: i64| match i {
                -1 if n > 2 => 3.0 * (y[0] - y[1]) + y[2],
                -1 => 2.0 * y[0] - y[1],
                i if i as usize == n && n > 2 => 3.0 * (y[n - 1] - y[n - 2]) + y[n - 3],
                i if i as usize == n => 2.0 * y[n - 1] - y[n - 2],
                i => y[i as usize],
            };
            let slopes: Vec<f64> = (0..n as i64).map(|i| (value(i + 1) - value(i - 1)) / (2.0 * h)).collect();
            hermite(x, y, &slopes, t)
        }
    }
}

/// One row for each y, one column for each x, as the matrix of the surface has it.
fn interp2(a: &mut Arguments) -> Outcome<Value> {
    let (x, y, z, at_x, at_y) = (a.numbers(0)?, a.numbers(1)?, a.array(2)?, a.numbers(3)?, a.numbers(4)?);
    let method = if a.len() > 5 { a.text(5)?.trim().to_ascii_lowercase() } else { "linear".to_string() };
    if !matches!(method.as_str(), "nearest" | "linear" | "spline" | "cubic") {
        return Err(a.error(format!("the method is nearest, linear, spline or cubic, not \"{method}\"")));
    }
    if (z.rows, z.columns) != (y.len(), x.len()) {
        return Err(a.error(format!(
            "the surface has {} rows and {} columns, but {} y and {} x values are given",
            z.rows,
            z.columns,
            y.len(),
            x.len()
        )));
    }
    sized(a, at_x.len().max(z.columns), at_y.len().max(z.rows))?;
    for (grid, at) in [(&x, &at_x), (&y, &at_y)] {
        checked_curve(a, grid.clone(), grid.clone())?;
        let even = grid.windows(3).all(|w| (w[2] - w[1] - (w[1] - w[0])).abs() <= 1e-9 * (w[2] - w[0]));
        if method == "cubic" && !even {
            return Err(a.error("the method cubic needs a grid of equal steps"));
        }
        if let Some(out) = at.iter().find(|t| **t < grid[0] || **t > grid[grid.len() - 1]) {
            return Err(a.error(format!("{} lies outside the grid", number_text(*out))));
        }
    }
    let mut values = Vec::with_capacity(at_x.len() * at_y.len());
    for u in &at_x {
        let line: Vec<f64> = (0..z.rows)
            .map(|r| {
                let row: Vec<f64> = (0..z.columns).map(|c| z.values[c * z.rows + r]).collect();
                along(&method, &x, &row, *u)
            })
            .collect();
        values.extend(at_y.iter().map(|v| along(&method, &y, &line, *v)));
    }
    Ok(Value::Array(Array { rows: at_y.len(), columns: at_x.len(), values }))
}

type Lifted = [f64; 3];

fn griddata(a: &mut Arguments) -> Outcome<Value> {
    let (x, y, z, at_x, at_y) = (a.numbers(0)?, a.numbers(1)?, a.numbers(2)?, a.numbers(3)?, a.numbers(4)?);
    if x.len() < 3 || x.len() != y.len() || x.len() != z.len() {
        return Err(a.error(format!("{} x, {} y and {} z values make no surface", x.len(), y.len(), z.len())));
    }
    if at_x.len() != at_y.len() {
        return Err(a.error("as many y as x values are needed"));
    }
    sized(a, x.len(), at_x.len())?;
    let range = |v: &[f64]| v.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
    let ((x0, x1), (y0, y1)) = (range(&x), range(&y));
    let size = (x1 - x0).max(y1 - y0);
    if size <= 0.0 {
        return Err(a.error("the points lie on each other"));
    }
    let (cx, cy) = (f64::midpoint(x0, x1), f64::midpoint(y0, y1));
    let scaled = |x: f64, y: f64| ((x - cx) / size, (y - cy) / size);
    let lifted: Vec<Lifted> = x
        .iter()
        .zip(&y)
        .map(|(x, y)| {
            let (u, v) = scaled(*x, *y);
            [u, v, u * u + v * v]
        })
        .collect();
    let mut out = Vec::with_capacity(at_x.len());
    for (px, py) in at_x.iter().zip(&at_y) {
        let (corners, weights) = triangle(&lifted, scaled(*px, *py))
            .ok_or_else(|| a.error(format!("{}, {} lies outside the points", number_text(*px), number_text(*py))))?;
        out.push(corners.iter().zip(weights).map(|(c, w)| w * z[*c]).sum());
    }
    column(out)
}

/// Weights of a point in a triangle; none if the triangle has no area.
fn barycentric([a, b, c]: [Lifted; 3], (x, y): (f64, f64)) -> Option<[f64; 3]> {
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if area.abs() < 1e-300 {
        return None;
    }
    let v = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
    let w = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
    Some([1.0 - v - w, v, w])
}

/// The triangle of Delaunay's triangulation that holds a point. Lifted to a paraboloid the
/// triangulation is the lower side of a convex body: from a triangle far above, corners are
/// exchanged for the point that lies deepest below, until none does.
fn triangle(points: &[Lifted], at: (f64, f64)) -> Option<([usize; 3], [f64; 3])> {
    let n = points.len();
    let far = [[-40.0, -30.0, 1e7], [40.0, -30.0, 1e7], [0.0, 50.0, 1e7]];
    let place = |i: usize| if i < n { points[i] } else { far[i - n] };
    let mut corners = [n, n + 1, n + 2];
    for _ in 0..4 * n + 64 {
        let spots = corners.map(place);
        let weights = barycentric(spots, at)?;
        let below = |p: &Lifted| {
            let w = barycentric(spots, (p[0], p[1]))?;
            Some(w.iter().zip(&spots).map(|(w, s)| w * s[2]).sum::<f64>() - p[2])
        };
        let deepest = (0..n)
            .filter(|i| !corners.contains(i))
            .filter_map(|i| below(&points[i]).map(|depth| (i, depth)))
            .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
        let (next, depth) = deepest.unwrap_or((0, 0.0));
        // Above the rounding of heights; 1e7 stands there while a far corner is left.
        let rounding = if corners.iter().any(|c| *c >= n) { 1e-7 } else { 1e-13 };
        if depth <= rounding {
            let inside = corners.iter().zip(weights).all(|(c, w)| *c < n || w.abs() <= 1e-9);
            // A point on the border may still hang on a far corner of no weight.
            let fixed = |i: usize| if corners[i] < n { corners[i] } else { 0 };
            return inside.then_some(([fixed(0), fixed(1), fixed(2)], weights));
        }
        let shares = barycentric(spots, (points[next][0], points[next][1]))?;
        let leaving = (0..3)
            .filter(|i| shares[*i] > 1e-14)
            .min_by(|i, j| (weights[*i].max(0.0) / shares[*i]).total_cmp(&(weights[*j].max(0.0) / shares[*j])))?;
        corners[leaving] = next;
    }
    None
}
