//! The arrow of a force, drawn at a marker.
#![doc = include_str!("docs.md")]

pub mod schema;
pub use schema::CLASS;
