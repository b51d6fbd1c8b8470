//! A matrix with all its values.

pub mod schema;
pub use schema::CLASS;
