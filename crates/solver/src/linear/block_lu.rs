//! Block LU: one analysis of the structure, then numeric factorisations that only follow offsets.
//!
//! Step `k` inverts the diagonal block `D`, turns each block `U` of its row into `D^-1 U`, and
//! subtracts `L (D^-1 U)` from the blocks where rows and columns of the coupled blocks meet. All
//! blocks of a step lie together in memory, in the order they are used.

use crate::Pattern;

use super::kernels;
use super::ordering::{Order, minimum_degree, neighbours};

/// Offsets of everything, from the structure alone.
pub struct Structure {
    /// Scalar offset of each block among the unknowns.
    pub offsets: Vec<usize>,
    pub sizes: Vec<usize>,
    /// Length of the value array.
    pub length: usize,
    steps: Vec<Step>,
    /// Coupled blocks of all steps.
    couplings: Vec<Coupling>,
    /// Where each product `L_i U_j` of all steps is subtracted.
    targets: Vec<u32>,
    /// Scalar offset in elimination order, by step.
    permuted: Vec<usize>,
    /// Blocks of the assembled matrix by row: `(column, offset of its values)`, sorted.
    rows: Vec<Vec<(u32, u32)>>,
    largest: usize,
}

struct Step {
    block: usize,
    size: usize,
    diagonal: usize,
    couplings: std::ops::Range<usize>,
    targets: usize,
}

struct Coupling {
    size: usize,
    /// Scalar offset of the coupled block in elimination order.
    permuted: usize,
    /// Offsets of the block below the diagonal and of the one to its right.
    lower: usize,
    upper: usize,
}

impl Structure {
    pub fn new(pattern: &Pattern) -> Self {
        let sizes = pattern.sizes.clone();
        let mut offsets = Vec::with_capacity(sizes.len());
        let mut total = 0;
        for &size in &sizes {
            offsets.push(total);
            total += size;
        }
        let order = minimum_degree(pattern);
        let (steps, couplings, permuted, length) = lay_out(&order, &sizes);
        let mut structure = Self {
            offsets,
            length,
            steps,
            couplings,
            targets: Vec::new(),
            permuted,
            rows: Vec::new(),
            largest: sizes.iter().copied().max().unwrap_or(0),
            sizes,
        };
        structure.targets = structure.find_targets(&order);
        structure.rows = neighbours(pattern)
            .iter()
            .enumerate()
            .map(|(row, columns)| {
                let mut columns = columns.clone();
                columns.push(row);
                columns.sort_unstable();
                let place = |column: usize| structure.place(&order, order.step_of[row], order.step_of[column]);
                columns.iter().map(|&column| (column as u32, place(column) as u32)).collect()
            })
            .collect();
        structure
    }

    pub fn unknowns(&self) -> usize {
        self.sizes.iter().sum()
    }

    /// Offset of a block's values, if the pattern has it.
    pub fn slot(&self, row: usize, column: usize) -> Option<usize> {
        let row = self.rows.get(row)?;
        let at = row.binary_search_by_key(&(column as u32), |entry| entry.0).ok()?;
        Some(row[at].1 as usize)
    }

    /// Blocks of a row of the assembled matrix: `(column block, offset of the values)`.
    pub fn row(&self, row: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.rows[row].iter().map(|&(column, offset)| (column as usize, offset as usize))
    }

    /// Number of values in blocks that are filled in by elimination, for reports.
    #[cfg(test)]
    pub fn fill(&self) -> usize {
        let assembled: usize = (0..self.sizes.len())
            .map(|row| self.row(row).map(|(column, _)| self.sizes[row] * self.sizes[column]).sum::<usize>())
            .sum();
        self.length - assembled
    }

    /// Offset of the block at two steps, fill included.
    fn place(&self, order: &Order, row: usize, column: usize) -> usize {
        let early = row.min(column);
        if row == column {
            return self.steps[early].diagonal;
        }
        let position = order.coupled[early].partition_point(|&step| step < row.max(column));
        let coupling = &self.couplings[self.steps[early].couplings.start + position];
        if row > column { coupling.lower } else { coupling.upper }
    }

    fn find_targets(&mut self, order: &Order) -> Vec<u32> {
        let mut targets = Vec::new();
        for (k, coupled) in order.coupled.iter().enumerate() {
            self.steps[k].targets = targets.len();
            for &column in coupled {
                for &row in coupled {
                    targets.push(self.place(order, row, column) as u32);
                }
            }
        }
        targets
    }

    /// Factors `values` in place. On failure returns the scalar unknown without a pivot.
    ///
    /// `diagonal` holds the absolute values of the assembled diagonal in elimination order.
    #[inline(always)]
    pub fn factor(&self, values: &mut [f64], scratch: &mut Scratch) -> Result<(), usize> {
        let Scratch { product, pivots, reference, .. } = scratch;
        for step in &self.steps {
            let n = step.size;
            let couplings = &self.couplings[step.couplings.clone()];
            // Blocks of later steps lie behind this step's own.
            let own_end = step.diagonal + n * n + couplings.iter().map(|c| 2 * n * c.size).sum::<usize>();
            let (head, tail) = values.split_at_mut(own_end);
            let own = &mut head[step.diagonal..];
            let (diagonal, own) = own.split_at_mut(n * n);
            let at = self.permuted_of(step);
            kernels::invert(n, diagonal, &reference[at..at + n], pivots)
                .map_err(|row| self.offsets[step.block] + row)?;
            let mut target = step.targets;
            for column in couplings {
                let upper = column.upper - step.diagonal - n * n;
                let upper_length = n * column.size;
                let (before, rest) = own.split_at_mut(upper);
                let (upper_block, after) = rest.split_at_mut(upper_length);
                kernels::product(n, column.size, diagonal, upper_block, product);
                upper_block.copy_from_slice(&product[..upper_length]);
                for row in couplings {
                    let lower = row.lower - step.diagonal - n * n;
                    let lower_length = n * row.size;
                    let lower_block = if lower < upper {
                        &before[lower..lower + lower_length]
                    } else {
                        &after[lower - upper - upper_length..][..lower_length]
                    };
                    let place = self.targets[target] as usize - own_end;
                    target += 1;
                    kernels::subtract_product(
                        row.size,
                        n,
                        column.size,
                        lower_block,
                        upper_block,
                        &mut tail[place..place + row.size * column.size],
                    );
                }
            }
        }
        Ok(())
    }

    /// Solves in place with the factored values; `x` is in elimination order.
    #[inline(always)]
    pub fn substitute(&self, values: &[f64], x: &mut [f64], scratch: &mut Scratch) {
        let product = &mut scratch.product;
        for step in &self.steps {
            let n = step.size;
            let at = self.permuted_of(step);
            let (head, tail) = x.split_at_mut(at + n);
            let own = &mut head[at..];
            kernels::matvec_in_place(n, &values[step.diagonal..step.diagonal + n * n], own, product);
            for row in &self.couplings[step.couplings.clone()] {
                let place = row.permuted - at - n;
                let lower = &values[row.lower..row.lower + n * row.size];
                kernels::subtract_matvec(row.size, n, lower, own, &mut tail[place..place + row.size]);
            }
        }
        for step in self.steps.iter().rev() {
            let n = step.size;
            let at = self.permuted_of(step);
            let (head, tail) = x.split_at_mut(at + n);
            let own = &mut head[at..];
            for column in &self.couplings[step.couplings.clone()] {
                let place = column.permuted - at - n;
                let upper = &values[column.upper..column.upper + n * column.size];
                kernels::subtract_matvec(n, column.size, upper, &tail[place..place + column.size], own);
            }
        }
    }

    /// Copies between the order of the unknowns and that of elimination.
    pub fn permute(&self, x: &[f64], permuted: &mut [f64]) {
        for step in &self.steps {
            let (from, to) = (self.offsets[step.block], self.permuted_of(step));
            permuted[to..to + step.size].copy_from_slice(&x[from..from + step.size]);
        }
    }

    pub fn permute_back(&self, permuted: &[f64], x: &mut [f64]) {
        for step in &self.steps {
            let (to, from) = (self.offsets[step.block], self.permuted_of(step));
            x[to..to + step.size].copy_from_slice(&permuted[from..from + step.size]);
        }
    }

    /// Sizes of the assembled diagonal, in elimination order: what pivots are compared with.
    pub fn note_diagonal(&self, values: &[f64], reference: &mut [f64]) {
        for step in &self.steps {
            let at = self.permuted_of(step);
            for i in 0..step.size {
                reference[at + i] = values[step.diagonal + i * step.size + i].abs();
            }
        }
    }

    fn permuted_of(&self, step: &Step) -> usize {
        self.permuted[step.block]
    }
}

/// Working memory of a factorisation.
pub struct Scratch {
    product: Vec<f64>,
    pivots: Vec<usize>,
    pub reference: Vec<f64>,
    pub permuted: Vec<f64>,
}

impl Scratch {
    pub fn new(structure: &Structure) -> Self {
        let unknowns = structure.unknowns();
        Self {
            product: vec![0.0; structure.largest * structure.largest],
            pivots: vec![0; structure.largest],
            reference: vec![0.0; unknowns],
            permuted: vec![0.0; unknowns],
        }
    }
}

/// Places the blocks of each step one behind the other. The permuted offsets are by block.
fn lay_out(order: &Order, sizes: &[usize]) -> (Vec<Step>, Vec<Coupling>, Vec<usize>, usize) {
    let mut permuted = vec![0; sizes.len()];
    let mut place = 0;
    for &block in &order.blocks {
        permuted[block] = place;
        place += sizes[block];
    }
    let mut steps = Vec::with_capacity(order.blocks.len());
    let mut couplings = Vec::new();
    let mut length = 0;
    for (&block, coupled) in order.blocks.iter().zip(&order.coupled) {
        let size = sizes[block];
        let first = couplings.len();
        let diagonal = length;
        length += size * size;
        for &step in coupled {
            let other = order.blocks[step];
            let area = size * sizes[other];
            couplings.push(Coupling {
                size: sizes[other],
                permuted: permuted[other],
                lower: length,
                upper: length + area,
            });
            length += 2 * area;
        }
        steps.push(Step { block, size, diagonal, couplings: first..couplings.len(), targets: 0 });
    }
    (steps, couplings, permuted, length)
}
