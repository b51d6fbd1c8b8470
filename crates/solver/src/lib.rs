//! Integrators, statics, modes and linear algebra for constrained mechanical systems.
//!
//! The solver knows no mechanics: a problem is whatever implements [`Dae`].

mod dae;

pub use dae::{Dae, Evaluation, JacobianPoint, Pattern, Scales};
