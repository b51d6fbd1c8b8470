//! A point mass: a body without rotation.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
