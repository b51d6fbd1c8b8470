//! An array of numbers.

pub mod schema;
pub use schema::CLASS;
