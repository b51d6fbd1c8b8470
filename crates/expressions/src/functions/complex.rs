//! Eigenvalues and eigenvectors of a real matrix by complex arithmetic.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Complex {
    pub re: f64,
    pub im: f64,
}

const ZERO: Complex = Complex { re: 0.0, im: 0.0 };

impl Complex {
    fn new(re: f64, im: f64) -> Complex {
        Complex { re, im }
    }

    fn size(self) -> f64 {
        self.re.hypot(self.im)
    }

    fn conjugate(self) -> Complex {
        Complex::new(self.re, -self.im)
    }

    fn sqrt(self) -> Complex {
        let size = self.size();
        let re = f64::midpoint(size, self.re).max(0.0).sqrt();
        let im = ((size - self.re) / 2.0).max(0.0).sqrt();
        Complex::new(re, im.copysign(self.im))
    }
}

impl Add for Complex {
    type Output = Complex;
    fn add(self, o: Complex) -> Complex {
        Complex::new(self.re + o.re, self.im + o.im)
    }
}

impl Sub for Complex {
    type Output = Complex;
    fn sub(self, o: Complex) -> Complex {
        Complex::new(self.re - o.re, self.im - o.im)
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, o: Complex) -> Complex {
        Complex::new(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}

impl Div for Complex {
    type Output = Complex;
    fn div(self, o: Complex) -> Complex {
        let size = o.re * o.re + o.im * o.im;
        let p = self * o.conjugate();
        Complex::new(p.re / size, p.im / size)
    }
}

impl Neg for Complex {
    type Output = Complex;
    fn neg(self) -> Complex {
        Complex::new(-self.re, -self.im)
    }
}

/// Eigenvalues with their vectors.
pub(super) struct Spectrum {
    pub values: Vec<Complex>,
    pub vectors: Vec<Vec<Complex>>,
}

impl Spectrum {
    /// Of a matrix of n rows, given column by column. None if the iteration does not settle.
    pub fn of(n: usize, columns: &[f64]) -> Option<Spectrum> {
        let rows: Vec<Vec<Complex>> =
            (0..n).map(|r| (0..n).map(|c| Complex::new(columns[c * n + r], 0.0)).collect()).collect();
        let size = columns.iter().fold(0.0_f64, |s, x| s.max(x.abs()));
        let mut values = eigenvalues(hessenberg(rows.clone()), size)?;
        for v in &mut values {
            // Rounding leaves imaginary parts of this size to real eigenvalues.
            if v.im.abs() <= 1e-13 * size {
                v.im = 0.0;
            }
        }
        values.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
        pair(&mut values, size);
        let vectors = values.iter().enumerate().map(|(i, v)| eigenvector(&rows, *v, size, i)).collect();
        Some(Spectrum { values, vectors })
    }
}

/// Eigenvalues of a real matrix come in conjugate pairs; rounding may have parted their order.
fn pair(values: &mut [Complex], size: f64) {
    let mut i = 0;
    while i + 1 < values.len() {
        if values[i].im != 0.0 {
            let wanted = values[i].conjugate();
            let near = (i + 1..values.len())
                .min_by(|a, b| (values[*a] - wanted).size().total_cmp(&(values[*b] - wanted).size()));
            if let Some(j) = near.filter(|j| (values[*j] - wanted).size() <= 1e-6 * size) {
                values.swap(i + 1, j);
                if values[i].im > 0.0 {
                    values.swap(i, i + 1);
                }
                i += 1;
            }
        }
        i += 1;
    }
}

/// A similar matrix with zeros below the first subdiagonal, by eliminations with row exchange.
fn hessenberg(mut m: Vec<Vec<Complex>>) -> Vec<Vec<Complex>> {
    let n = m.len();
    for k in 1..n.saturating_sub(1) {
        let pivot = (k..n).max_by(|a, b| m[*a][k - 1].size().total_cmp(&m[*b][k - 1].size())).unwrap_or(k);
        if m[pivot][k - 1] == ZERO {
            continue;
        }
        m.swap(k, pivot);
        for row in &mut m {
            row.swap(k, pivot);
        }
        for i in k + 1..n {
            let factor = m[i][k - 1] / m[k][k - 1];
            if factor == ZERO {
                continue;
            }
            eliminate(&mut m, i, k, 0, factor);
            for row in &mut m {
                row[k] = row[k] + factor * row[i];
            }
        }
    }
    m
}

/// Takes a multiple of row `k` from row `i`, which is below it, from a column on.
fn eliminate(m: &mut [Vec<Complex>], i: usize, k: usize, from: usize, factor: Complex) {
    let (upper, lower) = m.split_at_mut(i);
    for (x, above) in lower[0].iter_mut().zip(&upper[k]).skip(from) {
        *x = *x - factor * *above;
    }
}

/// Shifted QR steps; each time the last subdiagonal element vanishes, one value is found.
fn eigenvalues(mut m: Vec<Vec<Complex>>, size: f64) -> Option<Vec<Complex>> {
    let mut values = Vec::with_capacity(m.len());
    let mut end = m.len();
    let mut steps = 0;
    while end > 0 {
        let start = (1..end)
            .rev()
            .find(|i| {
                let near = m[*i][*i].size() + m[i - 1][i - 1].size();
                m[*i][i - 1].size() <= f64::EPSILON * if near == 0.0 { size } else { near }
            })
            .unwrap_or(0);
        if start + 1 >= end {
            values.push(m[end - 1][end - 1]);
            end -= 1;
            steps = 0;
            continue;
        }
        steps += 1;
        if steps > 300 {
            return None;
        }
        let shift = shift(&m, end, steps);
        for (i, row) in m.iter_mut().enumerate().take(end).skip(start) {
            row[i] = row[i] - shift;
        }
        let mut turns = Vec::with_capacity(end - start);
        for k in start..end - 1 {
            let (a, b) = (m[k][k], m[k + 1][k]);
            let length = a.size().hypot(b.size());
            if length == 0.0 {
                turns.push((Complex::new(1.0, 0.0), ZERO));
                continue;
            }
            let (c, s) = (Complex::new(a.re / length, a.im / length), Complex::new(b.re / length, b.im / length));
            let (upper, lower) = m.split_at_mut(k + 1);
            for (x, y) in upper[k].iter_mut().zip(&mut lower[0]).take(end).skip(k) {
                (*x, *y) = (c.conjugate() * *x + s.conjugate() * *y, c * *y - s * *x);
            }
            turns.push((c, s));
        }
        for (offset, (c, s)) in turns.into_iter().enumerate() {
            let k = start + offset;
            for row in m.iter_mut().take((k + 2).min(end)).skip(start) {
                let (x, y) = (row[k], row[k + 1]);
                row[k] = x * c + y * s;
                row[k + 1] = y * c.conjugate() - x * s.conjugate();
            }
        }
        for (i, row) in m.iter_mut().enumerate().take(end).skip(start) {
            row[i] = row[i] + shift;
        }
    }
    Some(values)
}

/// The eigenvalue of the last two rows that is nearer to the last element; now and then another
/// number, in case the steps run in a circle.
fn shift(m: &[Vec<Complex>], end: usize, steps: usize) -> Complex {
    let (i, j) = (end - 2, end - 1);
    if steps.is_multiple_of(10) {
        return Complex::new(m[j][i].size() + m[j][j].size(), 0.0);
    }
    let half = Complex::new(0.5, 0.0);
    let (mean, difference) = (half * (m[i][i] + m[j][j]), half * (m[i][i] - m[j][j]));
    let root = (difference * difference + m[i][j] * m[j][i]).sqrt();
    let (one, two) = (mean + root, mean - root);
    if (one - m[j][j]).size() < (two - m[j][j]).size() { one } else { two }
}

/// Inverse iteration next to the eigenvalue. The start differs from vector to vector, so that equal
/// eigenvalues give different vectors where there are any.
fn eigenvector(rows: &[Vec<Complex>], value: Complex, size: f64, number: usize) -> Vec<Complex> {
    let n = rows.len();
    let scale = if size == 0.0 { 1.0 } else { size };
    let near = value + Complex::new(scale * 1e-11, 0.0);
    let mut vector: Vec<Complex> =
        (0..n).map(|i| Complex::new(1.0 + if i == number { 1.0 } else { 0.1 * (i % 7) as f64 }, 0.0)).collect();
    for _ in 0..4 {
        let mut m: Vec<Vec<Complex>> = rows.to_vec();
        for (i, row) in m.iter_mut().enumerate() {
            row[i] = row[i] - near;
            row.push(vector[i]);
        }
        vector = solved(m, scale * f64::EPSILON);
        let largest = vector.iter().copied().fold(ZERO, |l, v| if v.size() > l.size() * (1.0 + 1e-9) { v } else { l });
        if largest == ZERO {
            return vector;
        }
        for v in &mut vector {
            *v = *v / largest;
        }
    }
    for v in &mut vector {
        let clean = |x: f64| if x.abs() < 1e-14 { 0.0 } else { x };
        *v = Complex::new(clean(v.re), clean(v.im));
    }
    vector
}

/// Solves a system whose right side is the last column; tiny pivots count as `least`.
fn solved(mut m: Vec<Vec<Complex>>, least: f64) -> Vec<Complex> {
    let n = m.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| m[*a][k].size().total_cmp(&m[*b][k].size())).unwrap_or(k);
        m.swap(k, pivot);
        if m[k][k].size() < least {
            m[k][k] = Complex::new(least, 0.0);
        }
        for i in k + 1..n {
            let factor = m[i][k] / m[k][k];
            if factor == ZERO {
                continue;
            }
            eliminate(&mut m, i, k, k, factor);
        }
    }
    let mut x = vec![ZERO; n];
    for k in (0..n).rev() {
        let known = (k + 1..n).fold(ZERO, |sum, j| sum + m[k][j] * x[j]);
        x[k] = (m[k][n] + -known) / m[k][k];
    }
    x
}
