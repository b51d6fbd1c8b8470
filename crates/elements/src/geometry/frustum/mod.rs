//! A frustum.

pub mod schema;
pub use schema::CLASS;
