//! The symbol of a spring with a damper between two markers.
#![doc = include_str!("docs.md")]

pub mod draw;
pub mod schema;
pub use schema::CLASS;
