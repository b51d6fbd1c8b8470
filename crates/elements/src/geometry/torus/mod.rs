//! A torus.

pub mod schema;
pub use schema::CLASS;
