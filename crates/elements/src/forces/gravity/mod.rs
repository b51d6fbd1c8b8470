//! Gravity: one acceleration for all bodies.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
