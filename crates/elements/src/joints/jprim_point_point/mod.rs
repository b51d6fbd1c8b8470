//! The primitive joint that keeps two points at a distance.

pub mod schema;
pub use schema::CLASS;
