//! A measure of an orientation.

pub mod schema;
pub use schema::CLASS;
