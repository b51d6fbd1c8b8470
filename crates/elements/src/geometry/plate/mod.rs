//! A plate.

pub mod schema;
pub use schema::CLASS;
