//! A constant-velocity joint between two shafts.

pub mod schema;
pub use schema::CLASS;
