//! A spring and damper about the common z axis of two markers.
#![doc = include_str!("docs.md")]

pub mod lower;
pub mod physics;
pub mod schema;
pub use schema::CLASS;
