//! The ground: the part that does not move.

pub mod schema;
pub use schema::CLASS;
