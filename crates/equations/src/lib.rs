//! Frames, bodies and the sockets `Force` and `Constraint`; the equations of motion that the
//! solver solves. SI throughout; names and units stay outside.
//!
//! Notation: `quantity _ from-to _ expressed-in`; `g` ground, `b` body frame at the centre of
//! mass, `i` and `j` an element's two markers. `r_ji_g` is the position of I from J in ground axes.

mod state;

mod sockets;

mod gradient;
mod load_gradient;
mod matrix;
mod relative;
mod scalar;

pub mod constraints;
pub mod measures;

mod accumulators;
pub mod layout;
mod motion;
mod pipeline;
mod spin;
mod system;

pub use gradient::{FrameCotangent, Gradient};
pub use load_gradient::{LoadCotangent, load_gradient};
pub use relative::{
    Relative, apply_between, apply_following, load_of_reaction, relative, tangent_between, tangent_following,
};
pub use scalar::{ScalarAction, apply_scalar, scalar_load, tangent_gradient, tangent_scalar};
pub use sockets::{
    Concern, Constraint, ConstraintRows, Force, FrameLoad, Inside, LoadOfState, Loads, Member, Side, Tangent, skew,
};
pub use spin::Spin;
pub use state::{Axis, Body, BodyId, BodyMotion, Frame, FrameId, FrameMotion, GROUND, State};
pub use system::{EquationRow, System};
