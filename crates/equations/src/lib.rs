//! Frames, bodies and the sockets `Force` and `Constraint`; the equations of motion that the
//! solver solves. SI throughout; names and units stay outside.
//!
//! Notation: `quantity _ from-to _ expressed-in`; `g` ground, `b` body frame at the centre of
//! mass, `i` and `j` an element's two markers. `r_ji_g` is the position of I from J in ground axes.

mod sockets;
mod state;

pub use sockets::{Constraint, ConstraintRows, Force, FrameLoad, Loads, Side, Tangent, skew};
pub use state::{Body, BodyId, BodyMotion, Frame, FrameId, FrameMotion, GROUND, State};
