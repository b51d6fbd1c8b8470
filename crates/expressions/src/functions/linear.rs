//! Linear algebra on small dense matrices (column-major): determinant, inverse, singular values,
//! balancing, eigenvalues of pairs of matrices.

use model::{Array, Value};

use super::{Arguments, Function, column, complex::Spectrum, function, matrix::transposed, real};
use crate::{arithmetic::matrix_product, scope::Outcome};

/// Largest side of a matrix whose eigenvalues are computed.
const LARGEST: usize = 100;

pub const TABLE: &[Function] = &[
    function("BALANCE", "matrix", "similar matrix whose rows and columns are about equally large", |a| {
        Ok(Value::Array(balanced(square(a, 0)?)))
    }),
    function("COND", "matrix", "condition number: largest over smallest singular value", |a| {
        let values = singular_values(&square(a, 0)?);
        let (least, most) = values.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), x| (l.min(*x), m.max(*x)));
        if least == 0.0 || !least.is_finite() {
            return Err(a.error("the matrix is singular"));
        }
        real(most / least)
    }),
    function("DET", "matrix", "determinant", |a| real(determinant(square(a, 0)?))),
    function("EIG_DI", "a, b", "diagonal matrix of the imaginary parts of the eigenvalues of a pair", |a| {
        diagonal(spectrum(a)?.values.iter().map(|v| v.im).collect())
    }),
    function("EIG_DR", "a, b", "diagonal matrix of the real parts of the eigenvalues of a pair", |a| {
        diagonal(spectrum(a)?.values.iter().map(|v| v.re).collect())
    }),
    function("EIG_VI", "a, b", "imaginary parts of the eigenvectors of a pair, one a column", |a| {
        let vectors = spectrum(a)?.vectors;
        matrix(vectors.len(), vectors.iter().flatten().map(|v| v.im).collect())
    }),
    function("EIG_VR", "a, b", "real parts of the eigenvectors of a pair, one a column", |a| {
        let vectors = spectrum(a)?.vectors;
        matrix(vectors.len(), vectors.iter().flatten().map(|v| v.re).collect())
    }),
    function("EIGENVALUES_I", "a, b", "imaginary parts of the eigenvalues of a pair of matrices", |a| {
        column(spectrum(a)?.values.iter().map(|v| v.im).collect())
    }),
    function("EIGENVALUES_R", "a, b", "real parts of the eigenvalues of a pair of matrices", |a| {
        column(spectrum(a)?.values.iter().map(|v| v.re).collect())
    }),
    function("INVERSE", "matrix", "inverse of a square matrix", |a| {
        let matrix = square(a, 0)?;
        inverse(matrix).map(Value::Array).ok_or_else(|| a.error("the matrix is singular"))
    }),
    function("NORM", "matrix", "largest singular value", |a| {
        real(singular_values(&a.array(0)?).into_iter().fold(0.0, f64::max))
    }),
];

fn matrix(side: usize, values: Vec<f64>) -> Outcome<Value> {
    Ok(Value::Array(Array { rows: side, columns: side, values }))
}

fn diagonal(values: Vec<f64>) -> Outcome<Value> {
    let n = values.len();
    let mut all = vec![0.0; n * n];
    for (i, x) in values.into_iter().enumerate() {
        all[i * n + i] = x;
    }
    matrix(n, all)
}

/// Numbers l and vectors x with A x = l B x, in order of the real parts, then the imaginary ones.
/// Vectors are scaled so that their largest element is 1.
fn spectrum(a: &Arguments) -> Outcome<Spectrum> {
    let (left, right) = (square(a, 0)?, square(a, 1)?);
    if left.rows != right.rows {
        return Err(a.error(format!("the matrices have {} and {} rows", left.rows, right.rows)));
    }
    if left.rows > LARGEST {
        return Err(a.error(format!("matrices up to {LARGEST} rows are taken, not {}", left.rows)));
    }
    let inverse = inverse(right).ok_or_else(|| a.error("the second matrix is singular"))?;
    let product = matrix_product(&inverse, &left);
    Spectrum::of(product.rows, &product.values).ok_or_else(|| a.error("the eigenvalues were not found"))
}

/// Powers of two scale rows against columns until neither is much larger (Parlett and Reinsch).
fn balanced(mut m: Array) -> Array {
    let n = m.rows;
    // Each round at least halves a ratio that has at most 2100 binary digits.
    for _ in 0..3000 {
        let mut done = true;
        for i in 0..n {
            let others = |value: fn(usize, usize, usize) -> usize, m: &Array| -> f64 {
                (0..n).filter(|j| *j != i).map(|j| m.values[value(n, i, j)].abs()).sum()
            };
            let (mut c, mut r) = (others(|n, i, j| i * n + j, &m), others(|n, i, j| j * n + i, &m));
            if c == 0.0 || r == 0.0 || !c.is_finite() || !r.is_finite() {
                continue;
            }
            let (before, mut factor) = (c + r, 1.0_f64);
            while c < r / 2.0 {
                (c, r, factor) = (c * 2.0, r / 2.0, factor * 2.0);
            }
            while c >= r * 2.0 {
                (c, r, factor) = (c / 2.0, r * 2.0, factor / 2.0);
            }
            if factor != 1.0 && c + r < 0.95 * before {
                done = false;
                for j in 0..n {
                    m.values[j * n + i] /= factor;
                }
                for j in 0..n {
                    m.values[i * n + j] *= factor;
                }
            }
        }
        if done {
            break;
        }
    }
    m
}

/// Lengths of the columns after they have been turned until they are perpendicular to each other
/// (one-sided Jacobi rotations).
fn singular_values(a: &Array) -> Vec<f64> {
    let mut m = if a.rows < a.columns { transposed(a) } else { a.clone() };
    let rows = m.rows;
    for _ in 0..60 {
        let mut turned = false;
        for p in 0..m.columns {
            for q in p + 1..m.columns {
                let (left, right) = m.values.split_at_mut(q * rows);
                let (x, y) = (&mut left[p * rows..(p + 1) * rows], &mut right[..rows]);
                let dot = |u: &[f64], v: &[f64]| u.iter().zip(v).map(|(u, v)| u * v).sum::<f64>();
                let (xx, yy, xy) = (dot(x, x), dot(y, y), dot(x, y));
                if xy.abs() <= 1e-16 * (xx * yy).sqrt() || xy == 0.0 {
                    continue;
                }
                turned = true;
                let zeta = (yy - xx) / (2.0 * xy);
                let t = 1.0_f64.copysign(zeta) / (zeta.abs() + zeta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                for (u, v) in x.iter_mut().zip(y) {
                    (*u, *v) = (c * (*u - t * *v), c * (t * *u + *v));
                }
            }
        }
        if !turned {
            break;
        }
    }
    m.values.chunks_exact(rows.max(1)).map(|c| c.iter().map(|x| x * x).sum::<f64>().sqrt()).collect()
}

fn square(a: &Arguments, i: usize) -> Outcome<Array> {
    let m = a.array(i)?;
    if m.rows == m.columns { Ok(m) } else { Err(a.error(format!("a {} x {} matrix is not square", m.rows, m.columns))) }
}

/// Gauss-Jordan elimination with row exchange, of a matrix and of another beside it. Returns the
/// determinant.
fn eliminate(m: &mut Array, mut other: Option<&mut Array>) -> f64 {
    let n = m.rows;
    let mut determinant = 1.0;
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| m.values[k * n + i].abs().total_cmp(&m.values[k * n + j].abs())).unwrap_or(k);
        if pivot != k {
            determinant = -determinant;
            for matrix in std::iter::once(&mut *m).chain(other.as_deref_mut()) {
                for c in 0..n {
                    matrix.values.swap(c * n + k, c * n + pivot);
                }
            }
        }
        let p = m.values[k * n + k];
        determinant *= p;
        if p == 0.0 {
            return 0.0;
        }
        for i in 0..n {
            // Without a right side, only what lies below matters.
            if i == k || (other.is_none() && i < k) {
                continue;
            }
            let factor = m.values[k * n + i] / p;
            if factor == 0.0 {
                continue;
            }
            for matrix in std::iter::once(&mut *m).chain(other.as_deref_mut()) {
                for c in 0..n {
                    let above = matrix.values[c * n + k];
                    matrix.values[c * n + i] -= factor * above;
                }
            }
        }
    }
    determinant
}

fn determinant(mut m: Array) -> f64 {
    eliminate(&mut m, None)
}

fn inverse(mut m: Array) -> Option<Array> {
    let n = m.rows;
    let size = m.values.iter().fold(0.0_f64, |s, x| s.max(x.abs()));
    let mut result = Array { rows: n, columns: n, values: vec![0.0; n * n] };
    for i in 0..n {
        result.values[i * n + i] = 1.0;
    }
    eliminate(&mut m, Some(&mut result));
    for i in 0..n {
        let p = m.values[i * n + i];
        // Rounding leaves pivots of about 1e-16 of the largest element in a singular matrix.
        if p.abs() <= 1e-15 * size {
            return None;
        }
        for c in 0..n {
            result.values[c * n + i] /= p;
        }
    }
    Some(result)
}
