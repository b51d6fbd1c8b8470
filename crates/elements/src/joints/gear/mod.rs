//! A gear pair: two joints that share the velocity of a point.

pub mod schema;
pub use schema::CLASS;
