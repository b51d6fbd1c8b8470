//! The section of a round tube.

pub mod schema;
pub use schema::CLASS;
