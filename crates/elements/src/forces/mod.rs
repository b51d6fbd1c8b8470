//! Elements that put loads on bodies.

pub mod beam;
pub mod gravity;
pub mod single_component_force;
