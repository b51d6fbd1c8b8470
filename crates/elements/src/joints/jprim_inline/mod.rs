//! The primitive joint that keeps a point on a line.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
