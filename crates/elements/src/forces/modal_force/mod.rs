//! A distributed load on a flexible body in terms of its modes.

pub mod schema;
pub use schema::CLASS;
