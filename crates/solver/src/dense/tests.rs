//! Dense algebra by its defining equations.

use proptest::prelude::*;

use super::{Lu, Matrix, eigenpairs, null_space};

fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}

/// Largest `|A x - s x|` over `|A| |x|`.
fn defect(a: &Matrix, value: [f64; 2], vector: &[[f64; 2]]) -> f64 {
    let part = |at: usize| a.times_vector(&vector.iter().map(|x| x[at]).collect::<Vec<_>>());
    let (real, imaginary) = (part(0), part(1));
    let norm = a.values.iter().fold(1e-300f64, |m, v| m.max(v.abs())) * a.rows() as f64;
    let size = vector.iter().fold(0.0f64, |m, x| m.max(x[0].hypot(x[1])));
    (0..a.rows())
        .map(|i| {
            let [re, im] = vector[i];
            let dr = real[i] - (value[0] * re - value[1] * im);
            let di = imaginary[i] - (value[0] * im + value[1] * re);
            dr.hypot(di)
        })
        .fold(0.0, f64::max)
        / (norm * size)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Truth: `A x = s x`, and the eigenvalues add up to the trace. Some entries are made zero and
    /// rows are scaled, so that there is something to deflate.
    #[test]
    fn eigenpairs_meet_their_definition(n in 1usize..30, sparsity in 0.0f64..0.9, start in 1u64..1 << 40) {
        let mut seed = start;
        let a = Matrix::from_fn(n, n, |i, _| {
            let value = random(&mut seed);
            if random(&mut seed) + 0.5 < sparsity { 0.0 } else { value * 10f64.powi(i as i32 % 4) }
        });
        let pairs = eigenpairs(a.clone()).unwrap();
        let mut sum = 0.0;
        let mut count = 0;
        for pair in &pairs {
            let both = if pair.value[1] > 0.0 { 2 } else { 1 };
            count += both;
            sum += f64::from(both) * pair.value[0];
            prop_assert!(pair.value[1] >= 0.0);
            // Backward stable: rounding times the norm, which `defect` divides by.
            prop_assert!(defect(&a, pair.value, &pair.vector) < 1e-13, "{:?}", pair.value);
        }
        prop_assert_eq!(count as usize, n);
        let trace: f64 = (0..n).map(|i| a[(i, i)]).sum();
        let norm = a.values.iter().fold(1e-300f64, |m, v| m.max(v.abs())) * n as f64;
        prop_assert!((sum - trace).abs() < 1e-12 * norm);
    }

    /// Truth: `B Z = 0`, `Z^T Z = 1`, and `Z` has as many columns as independent rows are missing.
    #[test]
    fn a_null_space_is_orthonormal_and_complete(n in 1usize..15, rank in 0usize..15, more in 0usize..4, start in 1u64..1 << 40) {
        let mut seed = start;
        let rank = rank.min(n);
        let left = Matrix::from_fn(rank + more, rank, |_, _| random(&mut seed));
        let right = Matrix::from_fn(rank, n, |_, _| random(&mut seed));
        let b = left.times(&right);
        let z = null_space(&b, 1e-11);
        prop_assert_eq!(z.columns(), n - rank);
        prop_assert!(b.times(&z).values.iter().all(|v| v.abs() < 1e-10));
        let unit = z.transposed_times(&z);
        for i in 0..unit.rows() {
            for j in 0..unit.columns() {
                let expected = if i == j { 1.0 } else { 0.0 };
                prop_assert!((unit[(i, j)] - expected).abs() < 1e-13);
            }
        }
    }

    /// Truth: `A (A^-1 b) = b`.
    #[test]
    fn lu_solves(n in 1usize..20, start in 1u64..1 << 40) {
        let mut seed = start;
        let a = Matrix::from_fn(n, n, |i, j| random(&mut seed) + if (i + 1) % n == j { 3.0 } else { 0.0 });
        let x: Vec<f64> = (0..n).map(|_| random(&mut seed)).collect();
        let mut found = a.times_vector(&x);
        Lu::new(a).solve(&mut found);
        for (f, e) in found.iter().zip(&x) {
            // Off-diagonal dominance keeps the condition below a hundred or so.
            prop_assert!((f - e).abs() < 1e-11);
        }
    }
}

/// Truth: the companion matrix of `(s-1)(s-2)...(s-8)` and a rotation, whose eigenvalues are on
/// the unit circle and defeat unshifted iterations.
#[test]
fn known_eigenvalues_are_found() {
    // Coefficients of the product, highest first without the leading 1.
    let mut coefficients = vec![1.0];
    for root in 1..=8 {
        let mut next = vec![0.0; coefficients.len() + 1];
        for (i, c) in coefficients.iter().enumerate() {
            next[i] += c;
            next[i + 1] -= f64::from(root) * c;
        }
        coefficients = next;
    }
    let companion = Matrix::from_fn(8, 8, |i, j| {
        if i == 0 {
            -coefficients[j + 1]
        } else if i == j + 1 {
            1.0
        } else {
            0.0
        }
    });
    let mut values: Vec<f64> = eigenpairs(companion).unwrap().iter().map(|pair| pair.value[0]).collect();
    values.sort_by(f64::total_cmp);
    for (k, value) in values.iter().enumerate() {
        // Roots of such polynomials are sensitive: the factor to rounding is about 1e6.
        assert!((value - (k + 1) as f64).abs() < 1e-8, "{values:?}");
    }
    let cycle = Matrix::from_fn(6, 6, |i, j| if (i + 1) % 6 == j { 1.0 } else { 0.0 });
    let mut angles: Vec<f64> =
        eigenpairs(cycle).unwrap().iter().map(|pair| pair.value[1].atan2(pair.value[0]).to_degrees()).collect();
    angles.sort_by(f64::total_cmp);
    for (angle, expected) in angles.iter().zip([0.0, 60.0, 120.0, 180.0]) {
        assert!((angle - expected).abs() < 1e-10, "{angles:?}");
    }
}

/// A structure at its critical load, written as `[0 1; -K 0]` with a `K` that is rounding: a cluster of
/// double zeros. Next to their neighbours the entries below the diagonal never become negligible, because
/// each sweep brings the rounding of the ones back; without the second measure of what is negligible the
/// iteration ends without eigenvalues for these seeds.
/// Truth: `|s|^2` is at most the norm of `K`, 1e-14 times the number of rows, but for the rounding of the
/// whole matrix, whose square root is all that is known of a double root.
#[test]
fn clusters_of_double_zeros_are_found() {
    for (n, start) in [(12_usize, 2_u64), (20, 8), (40, 0)] {
        let mut seed = start * 7919 + n as u64;
        let half = n / 2;
        let k = Matrix::from_fn(half, half, |_, _| 1e-14 * random(&mut seed));
        let a = Matrix::from_fn(n, n, |i, j| match (i < half, j < half) {
            (true, false) if j == i + half => 1.0,
            (false, true) => -k[(i - half, j)],
            _ => 0.0,
        });
        let pairs = eigenpairs(a.clone()).expect("the iteration converges");
        let count: usize = pairs.iter().map(|pair| if pair.value[1] > 0.0 { 2 } else { 1 }).sum();
        assert_eq!(count, n);
        for pair in &pairs {
            assert!(defect(&a, pair.value, &pair.vector) < 1e-13, "{:?}", pair.value);
            assert!(pair.value[0].hypot(pair.value[1]) < 2e-6, "{:?}", pair.value);
        }
    }
}
