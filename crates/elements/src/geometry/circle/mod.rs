//! A circle.

pub mod schema;
pub use schema::CLASS;
