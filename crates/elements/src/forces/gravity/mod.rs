//! Gravity: one acceleration for all bodies.

pub mod schema;
pub use schema::CLASS;
