//! The settings of printed output.

pub mod schema;
pub use schema::CLASS;
