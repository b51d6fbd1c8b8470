//! An array of inputs.

pub mod schema;
pub use schema::CLASS;
