//! Dense matrices for modal analysis: products, LU, rank-revealing QR, eigenvalues.
//!
//! Models of a few hundred freedoms at most, once per command: plain loops are fast enough, and a
//! general package would cost more to compile than everything else in the solver together.

mod eigen;
mod hessenberg;
mod lu;
mod qr;
#[cfg(test)]
mod tests;

pub use eigen::eigenpairs;
pub use lu::Lu;
pub use qr::null_space;

use std::ops::{Index, IndexMut};

/// Column-major.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Matrix {
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, columns, values: vec![0.0; rows * columns] }
    }

    pub fn identity(n: usize) -> Self {
        Self::from_fn(n, n, |i, j| if i == j { 1.0 } else { 0.0 })
    }

    pub fn from_fn(rows: usize, columns: usize, mut value: impl FnMut(usize, usize) -> f64) -> Self {
        let mut matrix = Self::zeros(rows, columns);
        for j in 0..columns {
            for (i, entry) in matrix.column_mut(j).iter_mut().enumerate() {
                *entry = value(i, j);
            }
        }
        matrix
    }

    pub fn rows(&self) -> usize {
        self.rows
    }

    pub fn columns(&self) -> usize {
        self.columns
    }

    pub fn column(&self, j: usize) -> &[f64] {
        &self.values[j * self.rows..(j + 1) * self.rows]
    }

    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.values[j * self.rows..(j + 1) * self.rows]
    }

    pub fn is_finite(&self) -> bool {
        self.values.iter().all(|value| value.is_finite())
    }

    pub fn transposed(&self) -> Self {
        Self::from_fn(self.columns, self.rows, |i, j| self[(j, i)])
    }

    /// `self x`.
    pub fn times_vector(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.rows];
        for (j, &factor) in x.iter().enumerate().take(self.columns) {
            if factor != 0.0 {
                add_multiple(&mut y, self.column(j), factor);
            }
        }
        y
    }

    /// `self * other`.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zeros(self.rows, other.columns);
        for j in 0..other.columns {
            let column = self.times_vector(other.column(j));
            product.column_mut(j).copy_from_slice(&column);
        }
        product
    }

    /// `self^T * other`.
    pub fn transposed_times(&self, other: &Self) -> Self {
        Self::from_fn(self.columns, other.columns, |i, j| dot(self.column(i), other.column(j)))
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;

    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.values[j * self.rows + i]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        &mut self.values[j * self.rows + i]
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `y += factor x`.
fn add_multiple(y: &mut [f64], x: &[f64], factor: f64) {
    for (yi, xi) in y.iter_mut().zip(x) {
        *yi += factor * xi;
    }
}

/// Turns `x` into the reflector `v` with `v[0] = 1`; returns `(tau, beta)` such that
/// `(1 - tau v v^T) x = beta e_1`.
fn reflector(x: &mut [f64]) -> (f64, f64) {
    let Some((&first, rest)) = x.split_first() else { return (0.0, 0.0) };
    let largest = rest.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    if largest == 0.0 {
        if let Some(head) = x.first_mut() {
            *head = 1.0;
        }
        return (0.0, first);
    }
    // Squares of what is divided by the largest cannot overflow or vanish.
    let scale = largest.max(first.abs());
    let norm = scale * x.iter().map(|v| (v / scale) * (v / scale)).sum::<f64>().sqrt();
    let beta = if first > 0.0 { -norm } else { norm };
    let tau = (beta - first) / beta;
    for v in x.iter_mut() {
        *v /= first - beta;
    }
    x[0] = 1.0;
    (tau, beta)
}

/// `x -= tau v (v^T x)`.
fn reflect(v: &[f64], tau: f64, x: &mut [f64]) {
    let factor = -tau * dot(v, x);
    add_multiple(x, v, factor);
}
