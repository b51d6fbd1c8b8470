//! An array of start values.

pub mod schema;
pub use schema::CLASS;
