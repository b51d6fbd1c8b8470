//! A measure of the range of another.

pub mod schema;
pub use schema::CLASS;
