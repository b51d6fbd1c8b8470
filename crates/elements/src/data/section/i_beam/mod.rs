//! The section of an I of two equal flanges.

pub mod schema;
pub use schema::CLASS;
