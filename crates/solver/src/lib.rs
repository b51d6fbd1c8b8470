//! Integrators, statics, modes and linear algebra for constrained mechanical systems.
//!
//! The solver knows no mechanics: a problem is whatever implements [`Dae`]. An analysis begins
//! with [`initial`] conditions, goes on with [`integrate`], [`equilibrium`] or [`modes`], and
//! tells an [`Observer`] what it finds.

mod dae;
pub mod dense;
pub mod initial;
mod integrators;
pub mod linear;
mod lowest;
mod modes;
#[cfg(test)]
mod problems;
pub mod redundancy;
mod state;
mod statics;

pub use dae::{Dae, Evaluation, JacobianPoint, Pattern, Scales};
pub use integrators::{IntegratorOptions, Method, integrate, output_times};
pub use lowest::{Found, Look, LowMode, LowestModes};
pub use modes::{Mode, ModeOptions, Modes, modes};
pub use state::{Control, Failure, Observer, Progress, Reason, Silent, Statistics, SystemState};
pub use statics::{StaticMethod, StaticOptions, StaticReport, equilibrium};
