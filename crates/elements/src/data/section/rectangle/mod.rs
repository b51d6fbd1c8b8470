//! The section of a solid rectangle.

pub mod schema;
pub use schema::CLASS;
