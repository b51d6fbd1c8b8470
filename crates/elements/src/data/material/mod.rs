//! A material: density and elastic constants.

pub mod schema;
pub use schema::CLASS;
