//! LU with partial pivoting.

use super::{Matrix, add_multiple};

pub struct Lu {
    factors: Matrix,
    pivots: Vec<usize>,
}

impl Lu {
    /// Factors a square matrix. A vanishing pivot shows as infinite solutions.
    pub fn new(mut a: Matrix) -> Self {
        let n = a.rows();
        let mut pivots = Vec::with_capacity(n);
        for k in 0..n {
            let column = a.column(k);
            let best = (k..n).fold(k, |best, i| if column[i].abs() > column[best].abs() { i } else { best });
            pivots.push(best);
            for j in 0..n {
                a.column_mut(j).swap(k, best);
            }
            let (head, tail) = a.values.split_at_mut((k + 1) * n);
            let lower = &mut head[k * n..];
            let reciprocal = 1.0 / lower[k];
            lower[k + 1..].iter_mut().for_each(|l| *l *= reciprocal);
            for column in tail.chunks_exact_mut(n) {
                let factor = -column[k];
                add_multiple(&mut column[k + 1..], &lower[k + 1..], factor);
            }
        }
        Self { factors: a, pivots }
    }

    /// `x <- A^-1 x`.
    pub fn solve(&self, x: &mut [f64]) {
        let n = self.factors.rows();
        for (k, &pivot) in self.pivots.iter().enumerate() {
            x.swap(k, pivot);
        }
        for k in 0..n {
            let factor = -x[k];
            add_multiple(&mut x[k + 1..], &self.factors.column(k)[k + 1..], factor);
        }
        for k in (0..n).rev() {
            x[k] /= self.factors[(k, k)];
            let factor = -x[k];
            add_multiple(&mut x[..k], &self.factors.column(k)[..k], factor);
        }
    }
}
