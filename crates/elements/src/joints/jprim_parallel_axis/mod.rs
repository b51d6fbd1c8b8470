//! The primitive joint that keeps one axis parallel.

pub mod schema;
pub use schema::CLASS;
