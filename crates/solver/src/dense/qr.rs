//! QR with column pivoting, for the null space of constraint matrices.

use super::{Matrix, dot, reflect, reflector};

/// Orthonormal columns `Z` that span the null space of `b`: `b Z = 0`.
///
/// `b^T P = Q R` with the longest remaining column first; where the diagonal of `R` falls below
/// `tolerance` times its first entry, the rows of `b` depend on each other, and the columns of `Q`
/// from there on are the answer.
pub fn null_space(b: &Matrix, tolerance: f64) -> Matrix {
    let (m, n) = (b.rows(), b.columns());
    let mut a = b.transposed();
    let mut reflectors: Vec<(f64, Vec<f64>)> = Vec::new();
    let mut first = 0.0;
    for k in 0..m.min(n) {
        // Norms are formed anew: downdating loses them just when they become small.
        let norms: Vec<f64> = (k..m).map(|j| dot(&a.column(j)[k..], &a.column(j)[k..])).collect();
        let best = norms.iter().enumerate().fold(0, |best, (j, norm)| if *norm > norms[best] { j } else { best });
        let size = norms[best].sqrt();
        if k == 0 {
            first = size;
        }
        if size <= tolerance * first || size == 0.0 {
            break;
        }
        if best != 0 {
            for i in 0..n {
                let (at, other) = (a[(i, k)], a[(i, k + best)]);
                a[(i, k)] = other;
                a[(i, k + best)] = at;
            }
        }
        let mut v = a.column(k)[k..].to_vec();
        let (tau, _) = reflector(&mut v);
        for j in k + 1..m {
            reflect(&v, tau, &mut a.column_mut(j)[k..]);
        }
        reflectors.push((tau, v));
    }
    let rank = reflectors.len();
    let mut basis = Matrix::from_fn(n, n - rank, |i, j| if i == rank + j { 1.0 } else { 0.0 });
    for j in 0..n - rank {
        let column = basis.column_mut(j);
        for (k, (tau, v)) in reflectors.iter().enumerate().rev() {
            reflect(v, *tau, &mut column[k..]);
        }
    }
    basis
}
