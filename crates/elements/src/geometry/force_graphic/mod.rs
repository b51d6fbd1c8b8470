//! The arrow of a force, drawn at a marker.

pub mod schema;
pub use schema::CLASS;
