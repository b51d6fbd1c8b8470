//! The general sparse LU with partial pivoting, for matrices that defeat the block pivots: parts
//! without mass, statics of mechanisms without stiffness.
//!
//! Columns are eliminated from left to right; each is solved with the lower factor found so far,
//! at a cost proportional to the arithmetic (Gilbert and Peierls 1988). Columns come in the order
//! of the blocks, which keeps fill low as long as pivots are near the diagonal: so the diagonal is
//! taken unless another entry of its column is ten times larger.

use crate::Pattern;

use super::block_lu::Structure;
use super::ordering::minimum_degree;

/// The diagonal is a pivot when it has at least this part of the largest entry.
const THRESHOLD: f64 = 0.1;
const NONE: usize = usize::MAX;

/// Pattern and factors in compressed columns.
pub struct General {
    /// Unknown of each column, in the order of elimination.
    order: Vec<usize>,
    /// Entries of the matrix by column of elimination.
    starts: Vec<usize>,
    rows: Vec<usize>,
    /// Offset into the block values of each entry.
    sources: Vec<usize>,
    lower: Columns,
    upper: Columns,
    /// Diagonal of the upper factor.
    pivots: Vec<f64>,
    /// Row of each pivot, and the pivot of each row.
    row_of: Vec<usize>,
    pivot_of: Vec<usize>,
    /// What rows are multiplied by, to make their entries comparable.
    scaling: Vec<f64>,
    work: Vec<f64>,
}

/// Entries by column: rows of the matrix in the lower factor, pivots in the upper one.
#[derive(Default)]
struct Columns {
    starts: Vec<usize>,
    indices: Vec<usize>,
    values: Vec<f64>,
}

impl Columns {
    fn clear(&mut self) {
        self.starts.clear();
        self.starts.push(0);
        self.indices.clear();
        self.values.clear();
    }

    fn push(&mut self, index: usize, value: f64) {
        self.indices.push(index);
        self.values.push(value);
    }

    fn close(&mut self) {
        self.starts.push(self.indices.len());
    }

    fn column(&self, k: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.starts[k]..self.starts[k + 1];
        self.indices[range.clone()].iter().copied().zip(self.values[range].iter().copied())
    }
}

impl General {
    pub fn new(structure: &Structure, pattern: &Pattern) -> Self {
        let mut starts = vec![0];
        let (mut order, mut rows, mut sources) = (Vec::new(), Vec::new(), Vec::new());
        for block in minimum_degree(pattern).blocks {
            for column in 0..structure.sizes[block] {
                order.push(structure.offsets[block] + column);
                // The pattern is symmetric: rows of blocks serve as columns of blocks.
                for (row_block, _) in structure.row(block) {
                    let size = structure.sizes[row_block];
                    let Some(slot) = structure.slot(row_block, block) else { continue };
                    for row in 0..size {
                        rows.push(structure.offsets[row_block] + row);
                        sources.push(slot + column * size + row);
                    }
                }
                starts.push(rows.len());
            }
        }
        Self::from_columns(order, starts, rows, sources)
    }

    fn from_columns(order: Vec<usize>, starts: Vec<usize>, rows: Vec<usize>, sources: Vec<usize>) -> Self {
        let n = order.len();
        Self {
            order,
            starts,
            rows,
            sources,
            lower: Columns::default(),
            upper: Columns::default(),
            pivots: Vec::new(),
            row_of: Vec::new(),
            pivot_of: Vec::new(),
            scaling: Vec::new(),
            work: vec![0.0; n],
        }
    }

    /// Factors the assembled values. On failure returns the unknown without a pivot.
    pub fn factor(&mut self, values: &[f64]) -> Result<(), usize> {
        let n = self.order.len();
        self.lower.clear();
        self.upper.clear();
        self.pivots.clear();
        self.row_of.clear();
        self.pivot_of.clear();
        self.pivot_of.resize(n, NONE);
        self.scale_rows(values);
        let mut search = Search { stamp: vec![0; n], stack: Vec::new(), found: Vec::new() };
        let mut x = std::mem::take(&mut self.work);
        x.clear();
        x.resize(n, 0.0);
        let done = (0..n).try_for_each(|k| self.eliminate(k, values, &mut search, &mut x));
        self.work = x;
        done
    }

    fn scale_rows(&mut self, values: &[f64]) {
        self.scaling.clear();
        self.scaling.resize(self.order.len(), 0.0);
        for (&row, &source) in self.rows.iter().zip(&self.sources) {
            self.scaling[row] = self.scaling[row].max(values[source].abs());
        }
        for scale in &mut self.scaling {
            *scale = if *scale > 0.0 && scale.is_finite() { 1.0 / *scale } else { 1.0 };
        }
    }

    /// Column `k` of both factors. `x` is zero before and after.
    fn eliminate(&mut self, k: usize, values: &[f64], search: &mut Search, x: &mut [f64]) -> Result<(), usize> {
        let entries = self.starts[k]..self.starts[k + 1];
        search.found.clear();
        for at in entries.clone() {
            search.reach(self.rows[at], k + 1, &self.lower, &self.pivot_of);
        }
        for at in entries {
            let row = self.rows[at];
            x[row] += self.scaling[row] * values[self.sources[at]];
        }
        let mut best = NONE;
        let mut largest = 0.0;
        // Found in postorder: reversed, each row comes before those it changes.
        for &row in search.found.iter().rev() {
            let pivot = self.pivot_of[row];
            if pivot == NONE {
                continue;
            }
            let value = x[row];
            self.upper.push(pivot, value);
            x[row] = 0.0;
            if value != 0.0 {
                for (other, factor) in self.lower.column(pivot) {
                    x[other] -= factor * value;
                }
            }
        }
        self.upper.close();
        for &row in &search.found {
            if self.pivot_of[row] == NONE && x[row].abs() > largest {
                largest = x[row].abs();
                best = row;
            }
        }
        let diagonal = self.order[k];
        if best == NONE || !largest.is_finite() {
            return Err(diagonal);
        }
        if self.pivot_of[diagonal] == NONE && x[diagonal].abs() >= THRESHOLD * largest {
            best = diagonal;
        }
        let pivot = x[best];
        for &row in &search.found {
            if self.pivot_of[row] == NONE {
                // later columns relies on every row that was reached.
                if row != best && x[row] != 0.0 {
                    self.lower.push(row, x[row] / pivot);
                }
                x[row] = 0.0;
            }
        }
        self.lower.close();
        self.pivots.push(pivot);
        self.row_of.push(best);
        self.pivot_of[best] = k;
        Ok(())
    }

    /// `x <- A^-1 x`.
    pub fn solve(&mut self, x: &mut [f64]) {
        let n = self.pivots.len();
        for (xi, scale) in x.iter_mut().zip(&self.scaling) {
            *xi *= scale;
        }
        for k in 0..n {
            let value = x[self.row_of[k]];
            self.work[k] = value;
            if value != 0.0 {
                for (row, factor) in self.lower.column(k) {
                    x[row] -= factor * value;
                }
            }
        }
        for k in (0..n).rev() {
            let value = self.work[k] / self.pivots[k];
            self.work[k] = value;
            for (pivot, factor) in self.upper.column(k) {
                self.work[pivot] -= factor * value;
            }
        }
        for (&unknown, value) in self.order.iter().zip(&self.work) {
            x[unknown] = *value;
        }
    }
}

/// Rows that a column's entries reach through the lower factor, by depth-first search.
struct Search {
    /// Number of the last column whose search met a row.
    stamp: Vec<usize>,
    /// Rows on the way, each with the next entry of its column to follow.
    stack: Vec<(usize, usize)>,
    found: Vec<usize>,
}

impl Search {
    fn reach(&mut self, from: usize, stamp: usize, lower: &Columns, pivot_of: &[usize]) {
        if self.stamp[from] == stamp {
            return;
        }
        let begin = |row: usize| if pivot_of[row] == NONE { 0 } else { lower.starts[pivot_of[row]] };
        self.stamp[from] = stamp;
        self.stack.push((from, begin(from)));
        while let Some((row, next)) = self.stack.last_mut() {
            let end = if pivot_of[*row] == NONE { 0 } else { lower.starts[pivot_of[*row] + 1] };
            if *next >= end {
                self.found.push(*row);
                self.stack.pop();
                continue;
            }
            let to = lower.indices[*next];
            *next += 1;
            if self.stamp[to] != stamp {
                self.stamp[to] = stamp;
                self.stack.push((to, begin(to)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::General;
    use crate::dense::{Lu, Matrix};

    /// All entries of a sparse matrix, columns in the order given.
    fn sparse(a: &Matrix, order: Vec<usize>) -> (General, Vec<f64>) {
        let n = a.rows();
        let (mut starts, mut rows, mut sources) = (vec![0], Vec::new(), Vec::new());
        for &column in &order {
            for row in (0..n).filter(|&row| a[(row, column)] != 0.0) {
                rows.push(row);
                sources.push(column * n + row);
            }
            starts.push(rows.len());
        }
        let values = (0..n).flat_map(|j| a.column(j).to_vec()).collect();
        (General::from_columns(order, starts, rows, sources), values)
    }

    /// Rows (or columns) in an order that depends on the seed.
    fn shuffled(n: usize, random: &mut impl FnMut() -> f64) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, (random() * (i + 1) as f64) as usize);
        }
        order
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

        /// Twin: dense LU with partial pivoting. Strong entries stand at random places, one in each
        /// row and column, so most diagonals are zero; rows differ in size by up to a million.
        #[test]
        fn sparse_and_dense_solutions_agree(n in 1usize..40, density in 0.0f64..0.4, start in 1u64..1 << 40) {
            let mut seed = start;
            let mut random = || {
                seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (seed >> 11) as f64 / (1u64 << 53) as f64
            };
            let (strong, order) = (shuffled(n, &mut random), shuffled(n, &mut random));
            let a = Matrix::from_fn(n, n, |i, j| {
                let value = if strong[i] == j { 5.0 + random() } else { random() - 0.5 };
                let present = strong[i] == j || random() < density;
                if present { value * 10f64.powi(i as i32 % 7 - 3) } else { 0.0 }
            });
            let (mut general, values) = sparse(&a, order);
            prop_assert!(general.factor(&values).is_ok());
            let x: Vec<f64> = (0..n).map(|_| random() - 0.5).collect();
            let right = a.times_vector(&x);
            let (mut found, mut twin) = (right.clone(), right);
            general.solve(&mut found);
            Lu::new(a).solve(&mut twin);
            for i in 0..n {
                // The dense twin does not scale rows, so it may lose the six digits they differ by.
                prop_assert!((found[i] - x[i]).abs() < 1e-10, "{} {}", found[i], x[i]);
                prop_assert!((found[i] - twin[i]).abs() < 1e-7, "{} {}", found[i], twin[i]);
            }
            // The same memory again with other values.
            let doubled: Vec<f64> = values.iter().map(|value| 2.0 * value).collect();
            prop_assert!(general.factor(&doubled).is_ok());
            let mut half = found.clone();
            general.solve(&mut half);
            prop_assert!(half.iter().all(|value| value.is_finite()));
        }
    }

    /// Truth: two equal columns leave nothing for the second.
    #[test]
    fn equal_columns_are_singular() {
        let a = Matrix::from_fn(3, 3, |i, j| if j == 2 { i as f64 } else { (i * i + 1) as f64 });
        let (mut general, values) = sparse(&a, vec![0, 1, 2]);
        assert_eq!(general.factor(&values), Err(1));
    }
}
