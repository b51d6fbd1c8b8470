//! A screw: I moves along z of J as it turns.

pub mod schema;
pub use schema::CLASS;
