//! An ellipsoid.

pub mod schema;
pub use schema::CLASS;
