//! A matrix from a file.

pub mod schema;
pub use schema::CLASS;
