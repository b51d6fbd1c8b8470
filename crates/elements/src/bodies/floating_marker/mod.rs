//! A floating marker: a marker that an element moves during the run.

pub mod schema;
pub use schema::CLASS;
