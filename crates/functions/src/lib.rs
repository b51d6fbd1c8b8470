//! Run-time functions: parsed text becomes a tape that yields values and exact derivatives.
//!
//! The crate knows no mechanics: what depends on the state of the system (`DX(i, j, k)`) becomes a
//! [`Measure`] that the caller supplies. All values are in the model's units; angles in radians.

mod measure;

pub use measure::{Component, Measure, Resolver};
