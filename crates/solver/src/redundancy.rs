//! Which constraint equations say nothing new.
//!
//! Gaussian elimination on the sparse constraint Jacobian, row by row in the order of the
//! equations: a row that vanishes depends on rows before it. So later constraints lose their
//! equations first and, within one, later equations (rotations) before earlier ones. Which column
//! serves as a pivot does not change what depends on what; choosing the one that the fewest later
//! rows use keeps a chain's elimination local and the cost linear.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::linear::NewtonMatrix;
use crate::{Dae, Failure, JacobianPoint, SystemState};

/// Sparse rows: `(column, value)`, columns ascending.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct SparseRows {
    pub columns: usize,
    pub rows: Vec<Vec<(usize, f64)>>,
}

/// An equation that follows from earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Redundant {
    pub row: usize,
    /// What the equation's right side lacks to follow from the others too, in its own units: zero
    /// for a consistent equation.
    pub residual: f64,
}

/// A pivot smaller than this part of its row counts as zero.
pub const TOLERANCE: f64 = 1e-8;

/// Rows that depend on earlier rows, ascending. `right` holds the residuals `Phi` (or `Phi_t`) of
/// the equations, or nothing.
pub fn find(jacobian: &SparseRows, right: &[f64], tolerance: f64) -> Vec<Redundant> {
    let mut elimination = Elimination::new(jacobian);
    let mut redundant = Vec::new();
    for (row, entries) in jacobian.rows.iter().enumerate() {
        if let Some(residual) = elimination.reduce(entries, right.get(row).copied().unwrap_or(0.0), tolerance) {
            redundant.push(Redundant { row, residual });
        }
    }
    redundant
}

/// The constraint Jacobian of a problem.
pub fn jacobian(dae: &mut dyn Dae, state: &SystemState) -> Result<SparseRows, Failure> {
    let (n, m) = (dae.velocities(), dae.constraints());
    let pattern = dae.pattern();
    let mut matrix = NewtonMatrix::new(&pattern);
    let lambda = vec![0.0; m];
    let SystemState { t, q, v, a, .. } = state;
    let at = JacobianPoint { t: *t, q, v, a, lambda: &lambda, mass: 0.0, damping: 0.0, stiffness: 0.0 };
    matrix.assemble(dae, at).map_err(Failure::evaluation(*t))?;
    let mut rows = vec![Vec::new(); m];
    for (row, column, values) in matrix.blocks() {
        if row < pattern.velocity_blocks || column >= pattern.velocity_blocks {
            continue;
        }
        let (first, from, size) = (matrix.offset(row) - n, matrix.offset(column), matrix.size(row));
        for (at, &value) in values.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            rows[first + at % size].push((from + at / size, value));
        }
    }
    for row in &mut rows {
        row.sort_unstable_by_key(|entry| entry.0);
    }
    Ok(SparseRows { columns: n, rows })
}

/// A row that was kept, divided by its pivot.
struct Kept {
    entries: Vec<(usize, f64)>,
    right: f64,
}

struct Elimination {
    kept: Vec<Kept>,
    /// The kept row that has its pivot in a column.
    pivot_of: Vec<Option<usize>>,
    /// How many rows to come have an entry in a column.
    uses: Vec<usize>,
    value: Vec<f64>,
    present: Vec<bool>,
    touched: Vec<usize>,
    waiting: BinaryHeap<Reverse<usize>>,
}

impl Elimination {
    fn new(jacobian: &SparseRows) -> Self {
        let n = jacobian.columns;
        let mut uses = vec![0; n];
        for &(column, _) in jacobian.rows.iter().flatten() {
            uses[column] += 1;
        }
        Self {
            kept: Vec::new(),
            pivot_of: vec![None; n],
            uses,
            value: vec![0.0; n],
            present: vec![false; n],
            touched: Vec::new(),
            waiting: BinaryHeap::new(),
        }
    }

    fn touch(&mut self, column: usize) {
        if !self.present[column] {
            self.present[column] = true;
            self.touched.push(column);
            if let Some(row) = self.pivot_of[column] {
                self.waiting.push(Reverse(row));
            }
        }
    }

    /// Keeps the row, or returns what is left of its right side if it depends on those kept.
    fn reduce(&mut self, entries: &[(usize, f64)], right: f64, tolerance: f64) -> Option<f64> {
        let scale = entries.iter().fold(0.0, |largest: f64, entry| largest.max(entry.1.abs()));
        for &(column, value) in entries {
            self.uses[column] -= 1;
            self.touch(column);
            // Rows are scaled to a largest entry of one.
            self.value[column] += if scale > 0.0 { value / scale } else { 0.0 };
        }
        let mut right = if scale > 0.0 { right / scale } else { right };
        let mut growth: f64 = 1.0;
        while let Some(Reverse(row)) = self.waiting.pop() {
            // Entries of a kept row lie in columns whose pivots, if any, came later: order holds.
            let kept = std::mem::take(&mut self.kept[row].entries);
            let factor = kept.first().map_or(0.0, |pivot| self.value[pivot.0]);
            if factor != 0.0 {
                for &(column, value) in &kept {
                    self.touch(column);
                    self.value[column] -= factor * value;
                }
                // The pivot's column is empty now, not merely small.
                if let Some(pivot) = kept.first() {
                    self.value[pivot.0] = 0.0;
                }
                right -= factor * self.kept[row].right;
                growth = growth.max(factor.abs());
            }
            self.kept[row].entries = kept;
        }
        let largest = self.touched.iter().fold(0.0, |largest: f64, &c| largest.max(self.value[c].abs()));
        let dependent = largest <= tolerance * growth;
        if !dependent {
            self.touched.sort_unstable();
            let fit = |c: usize| self.value[c].abs() >= 0.2 * largest;
            let pivot = self.touched.iter().copied().filter(|&c| fit(c)).min_by_key(|&c| (self.uses[c], c));
            if let Some(pivot) = pivot {
                let reciprocal = 1.0 / self.value[pivot];
                let mut row = vec![(pivot, 1.0)];
                let rest = self.touched.iter().filter(|&&c| c != pivot && self.value[c].abs() > 1e-14 * largest);
                row.extend(rest.map(|&c| (c, self.value[c] * reciprocal)));
                self.pivot_of[pivot] = Some(self.kept.len());
                self.kept.push(Kept { entries: row, right: right * reciprocal });
            }
        }
        for &column in &self.touched {
            self.value[column] = 0.0;
            self.present[column] = false;
        }
        self.touched.clear();
        dependent.then_some(if scale > 0.0 { right * scale } else { right })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dense(rows: &[&[f64]]) -> SparseRows {
        SparseRows {
            columns: rows[0].len(),
            rows: rows
                .iter()
                .map(|row| row.iter().copied().enumerate().filter(|entry| entry.1 != 0.0).collect())
                .collect(),
        }
    }

    fn rows(found: &[Redundant]) -> Vec<usize> {
        found.iter().map(|r| r.row).collect()
    }

    /// Hinge with its axis along z at `(0, 0, z)` on a door whose frame is at the origin: three
    /// translations, then the two rotations about x and y.
    fn hinge(z: f64) -> [[f64; 6]; 5] {
        [
            [1.0, 0.0, 0.0, 0.0, z, 0.0],
            [0.0, 1.0, 0.0, -z, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        ]
    }

    /// Truth: one hinge leaves a door one freedom, so the second adds nothing: 5 of 10 equations go,
    /// all of the later hinge.
    #[test]
    fn a_door_on_two_hinges_loses_the_second() {
        let (a, b) = (hinge(0.3), hinge(1.7));
        let all: Vec<&[f64]> = a.iter().chain(&b).map(<[f64; 6]>::as_slice).collect();
        let found = find(&dense(&all), &[0.0; 10], TOLERANCE);
        assert_eq!(rows(&found), [5, 6, 7, 8, 9]);
        assert!(found.iter().all(|r| r.residual == 0.0));
    }

    /// Truth: with two ball joints instead, one of six equations is lost (both keep their distance).
    #[test]
    fn a_door_on_two_balls_loses_one() {
        let (a, b) = (hinge(0.3), hinge(1.7));
        let all: Vec<&[f64]> = a[..3].iter().chain(&b[..3]).map(<[f64; 6]>::as_slice).collect();
        assert_eq!(rows(&find(&dense(&all), &[], TOLERANCE)), [5]);
    }

    /// Truth: x = 1 and 2 x = 5 contradict each other by 3.
    #[test]
    fn a_contradiction_is_measured() {
        let found = find(&dense(&[&[1.0, 0.0], &[2.0, 0.0], &[0.0, 1.0]]), &[1.0, 5.0, 0.0], TOLERANCE);
        assert_eq!(rows(&found), [1]);
        assert!((found[0].residual - 3.0).abs() < 1e-12);
    }

    #[test]
    fn an_empty_row_is_redundant() {
        assert_eq!(rows(&find(&dense(&[&[0.0, 0.0], &[0.0, 1.0]]), &[], TOLERANCE)), [0]);
    }

    /// Truth: a chain of `n` links on hinges about parallel axes has `n` freedoms and 5 n equations,
    /// all independent; closing it on ground with one more hinge leaves `n - 2` freedoms and three
    /// redundant equations. Fill stays bounded, so the cost is linear.
    #[test]
    fn a_closed_chain_of_parallel_hinges_loses_three() {
        let n = 300;
        let mut jacobian = SparseRows { columns: 6 * n, rows: Vec::new() };
        let bend = |i: usize| (i as f64 * 0.7).sin();
        for joint in 0..=n {
            // Arms from the links' frames to the hinge; the hinge axis is z.
            for (kind, unit) in [(0, 0), (0, 1), (0, 2), (1, 3), (1, 4)] {
                let mut row = Vec::new();
                for (body, sign) in [(joint.wrapping_sub(1), -1.0), (joint, 1.0)] {
                    if body >= n {
                        continue;
                    }
                    let (x, y) = (-0.5 * sign, 0.3 * bend(body + joint));
                    row.push((6 * body + unit, sign));
                    if kind == 0 {
                        match unit {
                            0 => row.push((6 * body + 5, -sign * y)),
                            1 => row.push((6 * body + 5, sign * x)),
                            _ => row.extend([(6 * body + 3, sign * y), (6 * body + 4, -sign * x)]),
                        }
                    }
                }
                jacobian.rows.push(row);
            }
        }
        let found = find(&jacobian, &[], TOLERANCE);
        let last = 5 * n;
        assert_eq!(rows(&found), [last + 2, last + 3, last + 4]);
        let mut elimination = Elimination::new(&jacobian);
        for row in &jacobian.rows {
            elimination.reduce(row, 0.0, TOLERANCE);
        }
        let longest = elimination.kept.iter().map(|kept| kept.entries.len()).max().unwrap();
        println!("longest row: {longest}");
        assert!(longest < 60, "{longest}");
    }
}
