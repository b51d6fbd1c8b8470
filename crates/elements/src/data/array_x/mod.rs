//! An array of states.

pub mod schema;
pub use schema::CLASS;
