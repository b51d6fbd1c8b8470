//! A matrix with the values that are not zero.

pub mod schema;
pub use schema::CLASS;
