//! The primitive joint that keeps two axes perpendicular.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
