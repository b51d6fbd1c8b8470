//! The block factorisation against the general one, against exact answers, and its cost.

use proptest::prelude::*;

use super::block_lu::Structure;
use super::general::General;
use super::{FactorKind, NewtonMatrix};
use crate::Pattern;

fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}

/// Velocity blocks dominated by their diagonal, multiplier blocks with nothing on it.
fn fill_with_saddle(matrix: &mut NewtonMatrix, pattern: &Pattern, seed: &mut u64) {
    for (block, &size) in pattern.sizes.iter().enumerate().take(pattern.velocity_blocks) {
        let values: Vec<f64> =
            (0..size * size).map(|i| random(seed) + if i % (size + 1) == 0 { 8.0 } else { 0.0 }).collect();
        assert!(matrix.add(block, block, &values));
    }
    for &(row, column) in pattern.pairs.iter().filter(|pair| pair.0 < pair.1) {
        let (m, n) = (pattern.sizes[row], pattern.sizes[column]);
        let values: Vec<f64> = (0..m * n).map(|_| random(seed)).collect();
        let transposed: Vec<f64> = (0..m * n).map(|at| values[(at % n) * m + at / n]).collect();
        assert!(matrix.add(row, column, &values));
        assert!(matrix.add(column, row, &transposed));
    }
}

fn chain(n: usize) -> Pattern {
    let pairs = (1..n).flat_map(|i| [(i - 1, i), (i, i - 1)]).collect();
    Pattern { sizes: vec![6; n], velocity_blocks: n, pairs }
}

/// A tree of bodies with one joint to the parent each, and springs between random bodies.
fn mechanism(bodies: usize, springs: usize, seed: &mut u64) -> Pattern {
    let pick = |bound: usize, seed: &mut u64| ((random(seed) + 0.5) * bound as f64) as usize % bound;
    let mut sizes: Vec<usize> = (0..bodies).map(|i| if i % 5 == 4 { 3 } else { 6 }).collect();
    let mut pairs = std::collections::BTreeSet::new();
    for body in 0..bodies {
        let joint = sizes.len();
        sizes.push(1 + pick(3, seed));
        pairs.insert((body, joint));
        if body > 0 {
            pairs.insert((pick(body, seed), joint));
        }
    }
    for _ in 0..springs {
        let (a, b) = (pick(bodies, seed), pick(bodies, seed));
        if a != b {
            pairs.insert((a.min(b), a.max(b)));
        }
    }
    let pairs = pairs.iter().flat_map(|&(a, b)| [(a, b), (b, a)]).collect();
    Pattern { sizes, velocity_blocks: bodies, pairs }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    /// Twin: the sparse LU with partial pivoting, on the same assembled matrix.
    #[test]
    fn blocks_agree_with_the_general_factorisation(bodies in 1usize..25, springs in 0usize..30, start in 1u64..1 << 40) {
        let mut seed = start;
        let pattern = mechanism(bodies, springs, &mut seed);
        let mut matrix = NewtonMatrix::new(&pattern);
        fill_with_saddle(&mut matrix, &pattern, &mut seed);
        matrix.factor().unwrap();
        let right: Vec<f64> = (0..matrix.unknowns()).map(|_| random(&mut seed)).collect();
        let mut x = right.clone();
        matrix.solve_refined(&mut x);
        let structure = Structure::new(&pattern);
        let mut values = vec![0.0; structure.length];
        for (row, column, block) in matrix.blocks() {
            let slot = structure.slot(row, column).unwrap();
            values[slot..slot + block.len()].copy_from_slice(block);
        }
        let mut general = General::new(&structure, &pattern);
        prop_assert!(general.factor(&values).is_ok());
        let mut y = right;
        general.solve(&mut y);
        let size = y.iter().fold(1.0f64, |m, v| m.max(v.abs()));
        for (a, b) in x.iter().zip(&y) {
            // Random joints come close to singular: lose a few digits to conditioning.
            prop_assert!((a - b).abs() < 1e-8 * size, "{a} {b}");
        }
    }
}

/// Truth: a block tridiagonal matrix eliminated from one end fills nothing, and a tree of joints
/// neither between bodies; so storage grows exactly as the length does.
#[test]
fn a_chain_does_not_fill_in() {
    for n in [10, 100, 1000] {
        let matrix = NewtonMatrix::new(&chain(n));
        assert_eq!(matrix.fill(), 0, "n = {n}");
    }
}

/// Truth: `[0 1; 1 0]` as two velocity blocks of one unknown each has no pivot inside its blocks
/// but is its own inverse.
#[test]
fn a_missing_block_pivot_falls_back_to_full_pivoting() {
    let pattern = Pattern { sizes: vec![1, 1], velocity_blocks: 2, pairs: vec![(0, 1), (1, 0)] };
    let mut matrix = NewtonMatrix::new(&pattern);
    assert!(matrix.add(0, 1, &[1.0]) && matrix.add(1, 0, &[1.0]));
    matrix.factor().unwrap();
    assert_eq!(matrix.kind(), FactorKind::General);
    let mut x = [2.0, 3.0];
    matrix.solve(&mut x);
    assert_eq!(x, [3.0, 2.0]);
}

/// Truth: a matrix with an empty row has no inverse; the row is named.
#[test]
fn a_singular_matrix_names_the_unknown() {
    let pattern = Pattern { sizes: vec![2, 1], velocity_blocks: 2, pairs: vec![(0, 1), (1, 0)] };
    let mut matrix = NewtonMatrix::new(&pattern);
    assert!(matrix.add(0, 0, &[1.0, 0.0, 0.0, 0.0]) && matrix.add(1, 1, &[1.0]));
    assert_eq!(matrix.factor().unwrap_err().unknown, 1);
}
