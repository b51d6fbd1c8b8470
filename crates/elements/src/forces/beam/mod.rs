//! A massless elastic beam between two markers.
#![doc = include_str!("docs.md")]

#[cfg(test)]
#[path = "tests/complex_steps.rs"]
mod complex_steps;
pub mod corotational;
pub mod dual;
pub mod element;
pub mod lower;
pub mod physics;
pub mod schema;
pub mod verify;

pub use element::{Beam, SMALL_ANGLE};
pub use physics::{Angles, Formulation, Law, Section};
pub use schema::CLASS;
