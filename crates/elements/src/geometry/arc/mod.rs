//! An arc.

pub mod schema;
pub use schema::CLASS;
