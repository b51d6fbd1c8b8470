//! The settings of the results file.

pub mod schema;
pub use schema::CLASS;
