//! Constraints between two frames, made of primitive equations: joints, joint primitives, motions.

mod driven;
mod equation;
mod pair;

pub use driven::{Drive, Driven, TimeFunction};
pub use equation::{Angle, Equation};
pub use pair::Pair;
