//! An array of outputs.

pub mod schema;
pub use schema::CLASS;
