//! States beside the mechanics: differential equations, transfer functions, state equations.

pub mod differential_equation;
pub mod general_state_equation;
pub mod linear_state_equation;
pub mod transfer_function;
