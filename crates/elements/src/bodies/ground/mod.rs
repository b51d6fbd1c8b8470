//! The ground: the part that does not move.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
