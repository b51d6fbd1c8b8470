//! A measure computed from others.

pub mod schema;
pub use schema::CLASS;
