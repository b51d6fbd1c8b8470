//! The shelf of elements: one folder for each kind of object a model may hold. The registry names
//! them; what they share in their schemas is in [`common`] and [`attributes`].

pub mod attributes;
pub mod bodies;
pub mod common;
pub mod data;
pub mod draw;
pub mod forces;
pub mod geometry;
pub mod joints;
pub mod lower;
pub mod mesh;
pub mod output;
pub mod place;
mod registry;
pub mod runtime;
pub mod shape;
pub mod shelf;
pub mod system;
#[cfg(test)]
mod testing;
pub mod verify;

pub use lower::{LoadId, Lowered, Options, active_objects, lower};
pub use output::Outputs;
pub use registry::registry;
pub use verify::{Finding, Verified, verify};
