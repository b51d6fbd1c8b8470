//! A group of objects.

pub mod schema;
pub use schema::CLASS;
