//! The Newton matrix: assembled by blocks, factored, solved with.

use crate::{Dae, Evaluation, JacobianPoint, Pattern};

use super::block_lu::{Scratch, Structure};
use super::general::General;
use super::vector::Vectors;

/// The matrix has no inverse; carries the unknown whose pivot vanished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Singular {
    pub unknown: usize,
}

/// How the present factors were made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FactorKind {
    /// Block by block, without pivoting across blocks.
    Blocks,
    /// General sparse LU with full partial pivoting: slower, needed when a block has no pivot.
    General,
}

/// A square matrix with the structure of a [`Pattern`], and its factors.
pub struct NewtonMatrix {
    structure: Structure,
    velocities: usize,
    velocity_blocks: usize,
    assembled: Vec<f64>,
    factors: Vec<f64>,
    scratch: Scratch,
    /// Blocks in the order they were last added, with their offsets: assembly repeats itself.
    replay: Vec<(u32, u32, u32)>,
    pattern: Pattern,
    general: Option<General>,
    kind: FactorKind,
    /// Set when the block factors were found wanting; then the general ones are used at once.
    distrust: bool,
    verified: bool,
    work: Vec<f64>,
    vectors: Vectors,
}

/// Relative backward error of a solution above which the block factors are not trusted.
const TRUST: f64 = 1e-6;

impl NewtonMatrix {
    pub fn new(pattern: &Pattern) -> Self {
        let structure = Structure::new(pattern);
        let velocities = pattern.sizes[..pattern.velocity_blocks].iter().sum();
        let scratch = Scratch::new(&structure);
        let unknowns = structure.unknowns();
        Self {
            velocities,
            velocity_blocks: pattern.velocity_blocks,
            assembled: vec![0.0; structure.length],
            factors: vec![0.0; structure.length],
            scratch,
            replay: Vec::new(),
            pattern: pattern.clone(),
            general: None,
            kind: FactorKind::Blocks,
            distrust: false,
            verified: false,
            work: vec![0.0; 2 * unknowns],
            vectors: Vectors::detect(),
            structure,
        }
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.structure.unknowns()
    }

    pub fn kind(&self) -> FactorKind {
        self.kind
    }

    pub fn clear(&mut self) {
        self.assembled.fill(0.0);
    }

    /// Fills the matrix from a problem; the factors stay as they are.
    pub fn assemble(&mut self, dae: &mut dyn Dae, at: JacobianPoint<'_>) -> Result<(), Evaluation> {
        self.clear();
        let (structure, assembled, replay) = (&self.structure, &mut self.assembled, &mut self.replay);
        let mut cursor = 0;
        let mut outside = None;
        dae.jacobian(at, &mut |row, column, values| {
            let slot = match replay.get(cursor) {
                Some(&(r, c, slot)) if r as usize == row && c as usize == column => slot as usize,
                _ => {
                    let Some(slot) = structure.slot(row, column) else {
                        outside = Some((row, column));
                        return;
                    };
                    replay.truncate(cursor);
                    replay.push((row as u32, column as u32, slot as u32));
                    slot
                }
            };
            cursor += 1;
            let length = structure.sizes[row] * structure.sizes[column];
            for (to, from) in assembled[slot..slot + length].iter_mut().zip(values) {
                *to += from;
            }
        })?;
        match outside {
            None => Ok(()),
            Some((row, column)) => {
                debug_assert!(false, "block ({row}, {column}) is not in the pattern");
                Err(Evaluation { message: format!("the equations couple blocks {row} and {column} unannounced") })
            }
        }
    }

    /// Adds a block (column-major). Returns false when the pattern has no such block.
    pub fn add(&mut self, row: usize, column: usize, values: &[f64]) -> bool {
        let Some(slot) = self.structure.slot(row, column) else { return false };
        for (to, from) in self.assembled[slot..].iter_mut().zip(values) {
            *to += from;
        }
        true
    }

    /// Adds one value to each entry of the diagonal, beginning with the first unknown.
    pub fn add_to_diagonal(&mut self, values: &[f64]) {
        let mut values = values.iter();
        for (block, &size) in self.structure.sizes.iter().enumerate() {
            let Some(slot) = self.structure.slot(block, block) else { continue };
            for i in 0..size {
                let Some(value) = values.next() else { return };
                self.assembled[slot + i * size + i] += value;
            }
        }
    }

    /// Factors the assembled matrix, with the general method when the blocks do not allow it.
    pub fn factor(&mut self) -> Result<(), Singular> {
        let mut unknown = 0;
        if !self.distrust {
            self.factors.copy_from_slice(&self.assembled);
            self.structure.note_diagonal(&self.assembled, &mut self.scratch.reference);
            let (structure, factors, scratch) = (&self.structure, &mut self.factors, &mut self.scratch);
            match self.vectors.run(|| structure.factor(factors, scratch)) {
                Ok(()) => {
                    self.kind = FactorKind::Blocks;
                    if self.verified || self.verify() {
                        self.verified = true;
                        return Ok(());
                    }
                }
                Err(row) => unknown = row,
            }
        }
        let general = self.general.get_or_insert_with(|| General::new(&self.structure, &self.pattern));
        general.factor(&self.assembled).map_err(|unknown| Singular { unknown })?;
        self.kind = FactorKind::General;
        self.distrust = true;
        if self.verify() { Ok(()) } else { Err(Singular { unknown: self.worst_unknown(unknown) }) }
    }

    /// Checks the next factors again before they are trusted.
    pub fn suspect(&mut self) {
        self.verified = false;
    }

    /// Solves for a right side made from a known vector and looks at what is left.
    fn verify(&mut self) -> bool {
        let n = self.unknowns();
        let mut work = std::mem::take(&mut self.work);
        let (x, b) = work.split_at_mut(n);
        // Neither smooth nor symmetric, so that no null vector of a mechanism hides from it.
        for (i, xi) in x.iter_mut().enumerate() {
            *xi = 1.0 + ((i * 7919) % 101) as f64 / 101.0;
        }
        self.multiply(x, b);
        x.copy_from_slice(b);
        self.solve(x);
        let fine = self.backward_error(x, b) < TRUST;
        self.work = work;
        fine
    }

    /// Largest `|b - A x|` in relation to the size of what was subtracted, row by row.
    fn backward_error(&self, x: &[f64], b: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        let mut largest: f64 = 0.0;
        for row in 0..self.structure.sizes.len() {
            let size = self.structure.sizes[row];
            let at = self.structure.offsets[row];
            for i in 0..size {
                let (mut sum, mut total) = (b[at + i], b[at + i].abs());
                for (column, slot) in self.structure.row(row) {
                    let from = self.structure.offsets[column];
                    for j in 0..self.structure.sizes[column] {
                        let term = self.assembled[slot + j * size + i] * x[from + j];
                        sum -= term;
                        total += term.abs();
                    }
                }
                largest = largest.max(total);
                if total > 0.0 {
                    worst = worst.max(sum.abs() / total);
                }
                if !sum.is_finite() {
                    return f64::INFINITY;
                }
            }
        }
        if largest == 0.0 { f64::INFINITY } else { worst }
    }

    /// The row of the assembled matrix with nothing in it, or what elimination found.
    fn worst_unknown(&self, found: usize) -> usize {
        for row in 0..self.structure.sizes.len() {
            for i in 0..self.structure.sizes[row] {
                let size = self.structure.sizes[row];
                let empty = self.structure.row(row).all(|(column, slot)| {
                    (0..self.structure.sizes[column]).all(|j| self.assembled[slot + j * size + i] == 0.0)
                });
                if empty {
                    return self.structure.offsets[row] + i;
                }
            }
        }
        found
    }

    /// Solves in place with the present factors.
    pub fn solve(&mut self, x: &mut [f64]) {
        if self.kind == FactorKind::General {
            if let Some(general) = &mut self.general {
                general.solve(x);
            }
            return;
        }
        let mut permuted = std::mem::take(&mut self.scratch.permuted);
        self.structure.permute(x, &mut permuted);
        let (structure, factors, scratch) = (&self.structure, &self.factors, &mut self.scratch);
        self.vectors.run(|| structure.substitute(factors, &mut permuted, scratch));
        self.structure.permute_back(&permuted, x);
        self.scratch.permuted = permuted;
    }

    /// Solves in place, then once more for the residual if that is not at rounding level. The
    /// assembled matrix must still be the one that was factored.
    pub fn solve_refined(&mut self, x: &mut [f64]) {
        let n = self.unknowns();
        let right = x.to_vec();
        self.solve(x);
        for _ in 0..2 {
            if self.backward_error(x, &right) < 1e-14 {
                return;
            }
            let mut work = std::mem::take(&mut self.work);
            let residual = &mut work[..n];
            self.multiply(x, residual);
            for (ri, bi) in residual.iter_mut().zip(&right) {
                *ri = bi - *ri;
            }
            self.solve(residual);
            for (xi, ri) in x.iter_mut().zip(residual.iter()) {
                *xi += ri;
            }
            self.work = work;
        }
    }

    /// `y = A x` with the assembled matrix.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        self.multiply_rows(0, x, y);
    }

    /// `y = B v`: the constraint rows of the assembled matrix times velocities.
    pub fn multiply_constraints(&self, v: &[f64], y: &mut [f64]) {
        for row in self.velocity_blocks..self.structure.sizes.len() {
            let size = self.structure.sizes[row];
            let at = self.structure.offsets[row] - self.velocities;
            let out = &mut y[at..at + size];
            out.fill(0.0);
            for (column, slot) in self.structure.row(row).filter(|entry| entry.0 < self.velocity_blocks) {
                let from = self.structure.offsets[column];
                for j in 0..self.structure.sizes[column] {
                    for (i, oi) in out.iter_mut().enumerate() {
                        *oi += self.assembled[slot + j * size + i] * v[from + j];
                    }
                }
            }
        }
    }

    fn multiply_rows(&self, first: usize, x: &[f64], y: &mut [f64]) {
        for row in first..self.structure.sizes.len() {
            let size = self.structure.sizes[row];
            let out = &mut y[self.structure.offsets[row]..][..size];
            out.fill(0.0);
            for (column, slot) in self.structure.row(row) {
                let from = self.structure.offsets[column];
                for j in 0..self.structure.sizes[column] {
                    let values = &self.assembled[slot + j * size..][..size];
                    for (oi, value) in out.iter_mut().zip(values) {
                        *oi += value * x[from + j];
                    }
                }
            }
        }
    }

    /// The blocks of the assembled matrix: `(row block, column block, values column-major)`.
    pub fn blocks(&self) -> impl Iterator<Item = (usize, usize, &[f64])> + '_ {
        (0..self.structure.sizes.len()).flat_map(move |row| {
            self.structure.row(row).map(move |(column, slot)| {
                let length = self.structure.sizes[row] * self.structure.sizes[column];
                (row, column, &self.assembled[slot..slot + length])
            })
        })
    }

    /// Scalar offset of a block.
    pub fn offset(&self, block: usize) -> usize {
        self.structure.offsets[block]
    }

    /// Size of a block.
    pub fn size(&self, block: usize) -> usize {
        self.structure.sizes[block]
    }

    #[cfg(test)]
    pub(super) fn fill(&self) -> usize {
        self.structure.fill()
    }
}
