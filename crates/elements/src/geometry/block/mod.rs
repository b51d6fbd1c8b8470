//! A block.

pub mod schema;
pub use schema::CLASS;
