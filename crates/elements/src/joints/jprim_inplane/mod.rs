//! The primitive joint that keeps a point in a plane.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
