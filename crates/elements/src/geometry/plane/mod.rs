//! A plane.
#![doc = include_str!("docs.md")]

pub mod draw;
pub mod schema;
pub use schema::CLASS;
