//! Linear algebra of the Newton matrix: block structure, ordering, factorisation, solution.
//!
//! [`NewtonMatrix`] is what the rest of the solver uses. It assembles blocks straight into the
//! storage of the factorisation, factors without looking at the structure again, and falls back
//! to a general sparse factorisation when a block has no usable pivot.

// The kernels must be inlined where the vector instructions are chosen.
#![allow(clippy::inline_always)]

mod block_lu;
mod general;
mod kernels;
mod newton_matrix;
mod ordering;
#[cfg(test)]
mod tests;
mod vector;

pub use newton_matrix::{FactorKind, NewtonMatrix, Singular};
