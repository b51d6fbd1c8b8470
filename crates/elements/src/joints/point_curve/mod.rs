//! A point of one body that stays on a curve of another.

pub mod schema;
pub use schema::CLASS;
