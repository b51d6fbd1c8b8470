//! The primitive joint that keeps a point on a line.

pub mod schema;
pub use schema::CLASS;
