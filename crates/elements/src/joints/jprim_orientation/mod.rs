//! The primitive joint that keeps axes parallel.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
