//! A spring and damper along the line between two markers.
#![doc = include_str!("docs.md")]

pub mod lower;
pub mod physics;
pub mod schema;
pub use schema::CLASS;
