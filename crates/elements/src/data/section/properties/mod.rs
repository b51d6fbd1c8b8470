//! A section of which only numbers are known.

pub mod schema;
pub use schema::CLASS;
