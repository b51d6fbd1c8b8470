//! A measure of a point.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
