//! A point mass: a body without rotation.

pub mod schema;
pub use schema::CLASS;
