//! Run-time functions: parsed text becomes a tape that yields values and exact derivatives.
//!
//! The crate knows no mechanics: what depends on the state of the system (`DX(i, j, k)`) becomes a
//! [`Measure`] that the caller supplies. All values are in the model's units; angles in radians.
//!
//! [`compile`] turns the tree of a function into a [`Function`]; `library/` has one file for each
//! function or small group; `rules` knows the derivatives of the basic operations, from which all
//! others follow.

mod compile;
mod evaluate;
mod library;
mod measure;
mod rules;
mod tape;

pub use compile::compile;
pub use evaluate::{Function, Mode};
pub use measure::{Component, Measure, Resolver};
