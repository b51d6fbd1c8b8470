//! A marker: a frame fixed in a body.

pub mod schema;
pub use schema::CLASS;
