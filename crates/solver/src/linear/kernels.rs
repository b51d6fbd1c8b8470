//! Kernels on small dense blocks, column-major.
//!
//! The six-by-six cases are compiled for that size: a chain of rigid bodies does nothing else.

/// `c -= a * b` with `a` of `m x k`, `b` of `k x n`.
#[inline(always)]
pub fn subtract_product(m: usize, k: usize, n: usize, a: &[f64], b: &[f64], c: &mut [f64]) {
    if m == 6 && k == 6 && n == 6 {
        subtract_product_fixed::<6, 6, 6>(a, b, c);
    } else {
        for j in 0..n {
            let (b_column, c_column) = (&b[j * k..(j + 1) * k], &mut c[j * m..(j + 1) * m]);
            for (a_column, &factor) in a.chunks_exact(m).zip(b_column) {
                for (ci, ai) in c_column.iter_mut().zip(a_column) {
                    *ci -= ai * factor;
                }
            }
        }
    }
}

#[inline(always)]
fn subtract_product_fixed<const M: usize, const K: usize, const N: usize>(a: &[f64], b: &[f64], c: &mut [f64]) {
    let (a, b, c) = (&a[..M * K], &b[..K * N], &mut c[..M * N]);
    for j in 0..N {
        let mut column = [0.0; M];
        column.copy_from_slice(&c[j * M..(j + 1) * M]);
        for k in 0..K {
            let factor = b[j * K + k];
            for i in 0..M {
                column[i] -= a[k * M + i] * factor;
            }
        }
        c[j * M..(j + 1) * M].copy_from_slice(&column);
    }
}

/// `c = a * b` with `a` of `m x m`, `b` of `m x n`.
#[inline(always)]
pub fn product(m: usize, n: usize, a: &[f64], b: &[f64], c: &mut [f64]) {
    if m == 6 && n == 6 {
        product_fixed::<6, 6>(a, b, c);
    } else {
        c[..m * n].fill(0.0);
        for j in 0..n {
            let (b_column, c_column) = (&b[j * m..(j + 1) * m], &mut c[j * m..(j + 1) * m]);
            for (a_column, &factor) in a.chunks_exact(m).zip(b_column) {
                for (ci, ai) in c_column.iter_mut().zip(a_column) {
                    *ci += ai * factor;
                }
            }
        }
    }
}

#[inline(always)]
fn product_fixed<const M: usize, const N: usize>(a: &[f64], b: &[f64], c: &mut [f64]) {
    let (a, b, c) = (&a[..M * M], &b[..M * N], &mut c[..M * N]);
    for j in 0..N {
        let mut column = [0.0; M];
        for k in 0..M {
            let factor = b[j * M + k];
            for i in 0..M {
                column[i] += a[k * M + i] * factor;
            }
        }
        c[j * M..(j + 1) * M].copy_from_slice(&column);
    }
}

/// `y -= a * x` with `a` of `m x n`.
#[inline(always)]
pub fn subtract_matvec(m: usize, n: usize, a: &[f64], x: &[f64], y: &mut [f64]) {
    if m == 6 && n == 6 {
        let (a, x, y) = (&a[..36], &x[..6], &mut y[..6]);
        let mut sum = [0.0; 6];
        for k in 0..6 {
            for i in 0..6 {
                sum[i] += a[k * 6 + i] * x[k];
            }
        }
        for i in 0..6 {
            y[i] -= sum[i];
        }
    } else {
        for (a_column, &factor) in a.chunks_exact(m).zip(&x[..n]) {
            for (yi, ai) in y.iter_mut().zip(a_column) {
                *yi -= ai * factor;
            }
        }
    }
}

/// `x <- a * x` with `a` of `n x n`; `scratch` has at least `n` entries.
#[inline(always)]
pub fn matvec_in_place(n: usize, a: &[f64], x: &mut [f64], scratch: &mut [f64]) {
    if n == 6 {
        let (a, x) = (&a[..36], &mut x[..6]);
        let mut sum = [0.0; 6];
        for k in 0..6 {
            for i in 0..6 {
                sum[i] += a[k * 6 + i] * x[k];
            }
        }
        x.copy_from_slice(&sum);
    } else {
        let sum = &mut scratch[..n];
        sum.fill(0.0);
        for (a_column, &factor) in a.chunks_exact(n).zip(x.iter()) {
            for (si, ai) in sum.iter_mut().zip(a_column) {
                *si += ai * factor;
            }
        }
        x[..n].copy_from_slice(sum);
    }
}

/// Replaces `a` (`n x n`) by its inverse, Gauss-Jordan with row pivoting. `pivots` and `reference`
/// have `n` entries; `reference` holds the size each row's diagonal had before anything was
/// subtracted from it. Returns the row without a usable pivot.
#[inline(always)]
pub fn invert(n: usize, a: &mut [f64], reference: &[f64], pivots: &mut [usize]) -> Result<(), usize> {
    if n == 6 { invert_sized::<6>(a, reference, pivots) } else { invert_any(n, a, reference, pivots) }
}

/// A pivot this much smaller than what its row began with is rounding noise.
const NOISE: f64 = 1e-15;

#[inline(always)]
fn invert_sized<const N: usize>(a: &mut [f64], reference: &[f64], pivots: &mut [usize]) -> Result<(), usize> {
    // The constant lets the compiler unroll the general code.
    invert_any(N, &mut a[..N * N], &reference[..N], &mut pivots[..N])
}

#[inline(always)]
fn invert_any(n: usize, a: &mut [f64], reference: &[f64], pivots: &mut [usize]) -> Result<(), usize> {
    for k in 0..n {
        let mut best = k;
        let mut size = a[k * n + k].abs();
        for i in k + 1..n {
            let candidate = a[k * n + i].abs();
            if candidate > size {
                size = candidate;
                best = i;
            }
        }
        pivots[k] = best;
        if !(size > NOISE * reference[k] && size > f64::MIN_POSITIVE && size.is_finite()) {
            return Err(k);
        }
        if best != k {
            for c in 0..n {
                a.swap(c * n + k, c * n + best);
            }
        }
        let reciprocal = 1.0 / a[k * n + k];
        a[k * n + k] = 1.0;
        for c in 0..n {
            a[c * n + k] *= reciprocal;
        }
        // Column k of the factors, cleared as it is used.
        for i in 0..n {
            if i == k {
                continue;
            }
            let factor = a[k * n + i];
            a[k * n + i] = 0.0;
            for c in 0..n {
                a[c * n + i] -= factor * a[c * n + k];
            }
        }
    }
    for k in (0..n).rev() {
        let other = pivots[k];
        if other != k {
            for i in 0..n {
                a.swap(k * n + i, other * n + i);
            }
        }
    }
    Ok(())
}
