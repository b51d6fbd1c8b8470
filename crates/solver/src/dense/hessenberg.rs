//! From a full matrix to the real Schur form: Hessenberg form, then Francis' double shifts (Golub
//! and Van Loan, Matrix Computations, chapter 7).
//!
//! There is no balancing: on sparse matrices it can scale without end, and what is asked here has
//! been scaled by its maker.

use super::{Matrix, reflect, reflector};

/// `A = V T V^T` with `T` quasi-triangular: blocks of two on its diagonal stand for pairs of
/// conjugate eigenvalues, and only for those.
pub struct Schur {
    pub form: Matrix,
    pub vectors: Matrix,
}

/// `None` when the iteration does not converge.
pub fn schur(mut a: Matrix) -> Option<Schur> {
    let vectors = to_hessenberg(&mut a);
    let mut schur = Schur { form: a, vectors };
    schur.iterate()?;
    Some(schur)
}

/// Reduces `a` by reflections from both sides and returns their product.
fn to_hessenberg(a: &mut Matrix) -> Matrix {
    let n = a.rows();
    let mut reflectors = Vec::new();
    let mut sums = vec![0.0; n];
    for k in 0..n.saturating_sub(2) {
        let mut v = a.column(k)[k + 1..].to_vec();
        let (tau, beta) = reflector(&mut v);
        let below = &mut a.column_mut(k)[k + 1..];
        below.fill(0.0);
        below[0] = beta;
        for j in k + 1..n {
            reflect(&v, tau, &mut a.column_mut(j)[k + 1..]);
        }
        // From the right, column by column.
        sums.fill(0.0);
        for (j, &vj) in v.iter().enumerate() {
            super::add_multiple(&mut sums, a.column(k + 1 + j), vj);
        }
        for (j, &vj) in v.iter().enumerate() {
            super::add_multiple(a.column_mut(k + 1 + j), &sums, -tau * vj);
        }
        reflectors.push((tau, v));
    }
    let mut vectors = Matrix::identity(n);
    for (k, (tau, v)) in reflectors.iter().enumerate().rev() {
        for j in k + 1..n {
            reflect(v, *tau, &mut vectors.column_mut(j)[k + 1..]);
        }
    }
    vectors
}

/// Iterations allowed for one eigenvalue; the usual number is two to four.
const ITERATIONS: usize = 90;
/// Iterations after which the rounding of the whole matrix is accepted.
const PATIENCE: usize = 30;

impl Schur {
    fn iterate(&mut self) -> Option<()> {
        let norm = self.form.values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let mut end = self.form.rows();
        let mut iterations = 0;
        while end > 0 {
            let last = end - 1;
            // What is small beside the neighbours keeps small eigenvalues sharp. Where rounding of the
            // large ones does not let it come to that, small beside the whole matrix must do.
            let least = if iterations > PATIENCE { norm * 8.0 * self.form.rows() as f64 } else { 0.0 };
            let start = self.split(last, norm, least);
            if start == last {
                end -= 1;
                iterations = 0;
            } else if start + 1 == last {
                self.standardise(last);
                end -= 2;
                iterations = 0;
            } else {
                iterations += 1;
                if iterations > ITERATIONS {
                    return None;
                }
                self.sweep(start, last, iterations % 10 == 0);
            }
        }
        Some(())
    }

    /// First row of the block that ends at `last` and has no negligible subdiagonal.
    /// Entries count as negligible beside their neighbours, or beside `least`.
    fn split(&mut self, last: usize, norm: f64, least: f64) -> usize {
        let h = &mut self.form;
        for i in (1..=last).rev() {
            let mut size = h[(i - 1, i - 1)].abs() + h[(i, i)].abs();
            if size == 0.0 {
                size = norm;
            }
            if h[(i, i - 1)].abs() <= f64::EPSILON * size.max(least) {
                h[(i, i - 1)] = 0.0;
                return i;
            }
        }
        0
    }

    /// One sweep with two shifts on rows `start..=last`.
    fn sweep(&mut self, start: usize, last: usize, exceptional: bool) {
        let h = &self.form;
        let (x, y, w) = if exceptional {
            // Shifts from elsewhere break the rare cycles.
            let s = h[(last, last - 1)].abs() + h[(last - 1, last - 2)].abs();
            let x = 0.75 * s + h[(last, last)];
            (x, x, -0.4375 * s * s)
        } else {
            (h[(last, last)], h[(last - 1, last - 1)], h[(last, last - 1)] * h[(last - 1, last)])
        };
        // Two small subdiagonals in a row let the sweep begin below them.
        let mut m = last - 2;
        let (mut p, mut q, mut r);
        loop {
            let z = h[(m, m)];
            p = ((x - z) * (y - z) - w) / h[(m + 1, m)] + h[(m, m + 1)];
            q = h[(m + 1, m + 1)] - z - (x - z) - (y - z);
            r = h[(m + 2, m + 1)];
            let size = p.abs() + q.abs() + r.abs();
            (p, q, r) = (p / size, q / size, r / size);
            if m == start {
                break;
            }
            let around = h[(m - 1, m - 1)].abs() + z.abs() + h[(m + 1, m + 1)].abs();
            if h[(m, m - 1)].abs() * (q.abs() + r.abs()) <= f64::EPSILON * p.abs() * around {
                break;
            }
            m -= 1;
        }
        for k in m..last {
            let three = k + 1 < last;
            let mut v = [p, q, if three { r } else { 0.0 }];
            if k > m {
                v = [self.form[(k, k - 1)], self.form[(k + 1, k - 1)], 0.0];
                if three {
                    v[2] = self.form[(k + 2, k - 1)];
                }
            }
            let (tau, beta) = reflector(&mut v);
            if k > m {
                self.form[(k, k - 1)] = beta;
                self.form[(k + 1, k - 1)] = 0.0;
                if three {
                    self.form[(k + 2, k - 1)] = 0.0;
                }
            } else if m > start {
                // The reflection acts on a row whose other entries to the left are negligible.
                self.form[(k, k - 1)] *= 1.0 - tau;
            }
            self.apply(k, last, &v[..if three { 3 } else { 2 }], tau);
        }
    }

    /// Applies a reflection of rows and columns from `k` on, from both sides.
    fn apply(&mut self, k: usize, last: usize, v: &[f64], tau: f64) {
        let n = self.form.rows();
        for j in k..n {
            reflect(v, tau, &mut self.form.column_mut(j)[k..k + v.len()]);
        }
        let rows = (k + 4).min(last + 1);
        from_right(&mut self.form, k, rows, v, tau);
        from_right(&mut self.vectors, k, n, v, tau);
    }

    /// A block of two with real eigenvalues is turned into a triangle.
    fn standardise(&mut self, last: usize) {
        let first = last - 1;
        let h = &self.form;
        let (below, above) = (h[(last, first)], h[(first, last)]);
        let half = 0.5 * (h[(first, first)] - h[(last, last)]);
        let discriminant = half * half + below * above;
        if discriminant < 0.0 {
            return;
        }
        let root = discriminant.sqrt();
        let distance = half + if half >= 0.0 { root } else { -root };
        let size = below.hypot(distance);
        if size == 0.0 {
            return;
        }
        let (cosine, sine) = (distance / size, below / size);
        let n = self.form.rows();
        for j in first..n {
            let (a, b) = (self.form[(first, j)], self.form[(last, j)]);
            self.form[(first, j)] = cosine * a + sine * b;
            self.form[(last, j)] = cosine * b - sine * a;
        }
        for (matrix, rows) in [(&mut self.form, last + 1), (&mut self.vectors, n)] {
            for i in 0..rows {
                let (a, b) = (matrix[(i, first)], matrix[(i, last)]);
                matrix[(i, first)] = cosine * a + sine * b;
                matrix[(i, last)] = cosine * b - sine * a;
            }
        }
        self.form[(last, first)] = 0.0;
    }
}

/// `A <- A (1 - tau v v^T)` on columns from `k` on, for the first `rows` rows.
fn from_right(a: &mut Matrix, k: usize, rows: usize, v: &[f64], tau: f64) {
    let n = a.rows();
    let columns = &mut a.values[k * n..(k + v.len()) * n];
    if let [_, v1, v2] = *v {
        let (c0, rest) = columns.split_at_mut(n);
        let (c1, c2) = rest.split_at_mut(n);
        for ((a0, a1), a2) in c0[..rows].iter_mut().zip(&mut c1[..rows]).zip(&mut c2[..rows]) {
            let sum = tau * (*a0 + v1 * *a1 + v2 * *a2);
            *a0 -= sum;
            *a1 -= v1 * sum;
            *a2 -= v2 * sum;
        }
    } else if let [_, v1] = *v {
        let (c0, c1) = columns.split_at_mut(n);
        for (a0, a1) in c0[..rows].iter_mut().zip(&mut c1[..rows]) {
            let sum = tau * (*a0 + v1 * *a1);
            *a0 -= sum;
            *a1 -= v1 * sum;
        }
    }
}
