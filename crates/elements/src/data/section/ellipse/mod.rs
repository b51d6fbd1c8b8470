//! The section of a solid ellipse.

pub mod schema;
pub use schema::CLASS;
