//! The primitive joint that keeps one axis parallel.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
