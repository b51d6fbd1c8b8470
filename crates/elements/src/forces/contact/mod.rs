//! A contact between shapes of two bodies.

pub mod schema;
pub use schema::CLASS;
