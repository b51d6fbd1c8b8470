//! The general sparse LU with full partial pivoting, for matrices that defeat the block pivots:
//! parts without mass, statics of mechanisms without stiffness.

use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMat, SymbolicSparseColMat};

use super::block_lu::Structure;

/// Pattern and factors in compressed columns.
pub struct General {
    symbolic: SymbolicLu<usize>,
    pattern: SymbolicSparseColMat<usize>,
    /// Offset into the block values of each entry, in column order.
    sources: Vec<usize>,
    factors: Option<Lu<usize, f64>>,
}

impl General {
    pub fn new(structure: &Structure) -> Option<Self> {
        let n = structure.unknowns();
        // The pattern is symmetric: rows of blocks serve as columns of blocks.
        let mut starts = vec![0];
        let mut rows = Vec::new();
        let mut sources = Vec::new();
        for column_block in 0..structure.sizes.len() {
            let columns = structure.sizes[column_block];
            for column in 0..columns {
                for (row_block, _) in structure.row(column_block) {
                    let size = structure.sizes[row_block];
                    let slot = structure.slot(row_block, column_block)?;
                    for row in 0..size {
                        rows.push(structure.offsets[row_block] + row);
                        sources.push(slot + column * size + row);
                    }
                }
                starts.push(rows.len());
            }
        }
        let pattern = SymbolicSparseColMat::new_checked(n, n, starts, None, rows);
        let symbolic = SymbolicLu::try_new(pattern.as_ref()).ok()?;
        Some(Self { symbolic, pattern, sources, factors: None })
    }

    /// Factors the assembled values. False when the matrix is singular.
    pub fn factor(&mut self, values: &[f64]) -> bool {
        let entries = self.sources.iter().map(|&source| values[source]).collect();
        let matrix = SparseColMat::new(self.pattern.clone(), entries);
        self.factors = Lu::try_new_with_symbolic(self.symbolic.clone(), matrix.as_ref()).ok();
        self.factors.is_some()
    }

    pub fn solve(&self, x: &mut [f64]) {
        if let Some(factors) = &self.factors {
            let mut right = Mat::from_fn(x.len(), 1, |i, _| x[i]);
            factors.solve_in_place(right.as_mut());
            for (i, xi) in x.iter_mut().enumerate() {
                *xi = right[(i, 0)];
            }
        }
    }
}
