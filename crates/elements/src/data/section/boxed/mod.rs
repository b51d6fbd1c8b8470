//! The section of a rectangular tube.

pub mod schema;
pub use schema::CLASS;
