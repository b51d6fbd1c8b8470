//! A link.

pub mod schema;
pub use schema::CLASS;
