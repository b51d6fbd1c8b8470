//! Eigenvalues and eigenvectors of a real matrix without symmetry.

use super::Matrix;
use super::hessenberg::{Schur, schur};

type Complex = [f64; 2];

/// An eigenvalue with non-negative imaginary part and its vector, of any length.
pub struct Eigenpair {
    pub value: Complex,
    pub vector: Vec<Complex>,
}

/// One pair for each real eigenvalue and for each two conjugate ones. `None` without convergence.
pub fn eigenpairs(a: Matrix) -> Option<Vec<Eigenpair>> {
    if !a.is_finite() {
        return None;
    }
    let schur = schur(a)?;
    let n = schur.form.rows();
    let mut found = Vec::with_capacity(n);
    let mut k = 0;
    while k < n {
        let h = &schur.form;
        let mut x = vec![[0.0; 2]; n];
        let pair = k + 1 < n && h[(k + 1, k)] != 0.0;
        let value = if pair {
            let (a, b, c, d) = (h[(k, k)], h[(k, k + 1)], h[(k + 1, k)], h[(k + 1, k + 1)]);
            let half = 0.5 * (a - d);
            let value = [d + half, (-(half * half + b * c)).max(0.0).sqrt()];
            (x[k], x[k + 1]) = if c.abs() >= b.abs() {
                ([value[0] - d, value[1]], [c, 0.0])
            } else {
                ([b, 0.0], [value[0] - a, value[1]])
            };
            value
        } else {
            x[k] = [1.0, 0.0];
            [h[(k, k)], 0.0]
        };
        substitute(&schur, value, k, pair, &mut x);
        found.push(Eigenpair { value, vector: unreduced(&schur, &x) });
        k += if pair { 2 } else { 1 };
    }
    Some(found)
}

/// Fills `x[..k]` such that `(T - value) x = 0`, given its entries from `k` on.
fn substitute(schur: &Schur, value: Complex, k: usize, pair: bool, x: &mut [Complex]) {
    let h = &schur.form;
    // The right side, by columns: what the entries known so far contribute.
    let mut right = vec![[0.0; 2]; k];
    let contribute = |right: &mut [Complex], column: usize, entry: Complex| {
        for (ri, hi) in right.iter_mut().zip(h.column(column)) {
            ri[0] -= hi * entry[0];
            ri[1] -= hi * entry[1];
        }
    };
    contribute(&mut right, k, x[k]);
    if pair {
        contribute(&mut right, k + 1, x[k + 1]);
    }
    // Equal eigenvalues: as far apart as rounding cannot tell.
    let smallest = f64::EPSILON * h.values.iter().fold(f64::MIN_POSITIVE / f64::EPSILON, |m, v| m.max(v.abs()));
    let apart = |d: Complex| if d[0].abs() + d[1].abs() < smallest { [smallest, 0.0] } else { d };
    let mut i = k;
    while i > 0 {
        i -= 1;
        let low = [h[(i, i)] - value[0], -value[1]];
        if i > 0 && h[(i, i - 1)] != 0.0 {
            let j = i - 1;
            let high = [h[(j, j)] - value[0], -value[1]];
            let (above, below) = (h[(j, i)], h[(i, j)]);
            // Elimination with the larger pivot: Cramer's rule loses everything where the block's
            // eigenvalues are close to the one asked about.
            let ([a, b, r], [c, d, s]) = if high[0].hypot(high[1]) >= below.abs() {
                ([high, [above, 0.0], right[j]], [[below, 0.0], low, right[i]])
            } else {
                ([[below, 0.0], low, right[i]], [high, [above, 0.0], right[j]])
            };
            let factor = over(c, a);
            x[i] = over(minus(s, times(factor, r)), apart(minus(d, times(factor, b))));
            x[j] = over(minus(r, times(b, x[i])), a);
            contribute(&mut right[..j], i, x[i]);
            contribute(&mut right[..j], j, x[j]);
            i = j;
        } else {
            x[i] = over(right[i], apart(low));
            contribute(&mut right[..i], i, x[i]);
        }
        let size = x[i][0].abs() + x[i][1].abs();
        if size > 1e100 {
            for entry in x.iter_mut().chain(&mut right) {
                *entry = [entry[0] / size, entry[1] / size];
            }
        }
    }
}

/// The vector in the coordinates of the matrix before any reduction.
fn unreduced(schur: &Schur, x: &[Complex]) -> Vec<Complex> {
    let part = |at: usize| schur.vectors.times_vector(&x.iter().map(|entry| entry[at]).collect::<Vec<_>>());
    let (real, imaginary) = (part(0), part(1));
    real.into_iter().zip(imaginary).map(|(re, im)| [re, im]).collect()
}

fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn minus(a: Complex, b: Complex) -> Complex {
    [a[0] - b[0], a[1] - b[1]]
}

/// Smith's division: no overflow on the way.
fn over(a: Complex, b: Complex) -> Complex {
    if b[0].abs() >= b[1].abs() {
        let ratio = b[1] / b[0];
        let denominator = b[0] + b[1] * ratio;
        [(a[0] + a[1] * ratio) / denominator, (a[1] - a[0] * ratio) / denominator]
    } else {
        let ratio = b[0] / b[1];
        let denominator = b[0] * ratio + b[1];
        [(a[0] * ratio + a[1]) / denominator, (a[1] * ratio - a[0]) / denominator]
    }
}
