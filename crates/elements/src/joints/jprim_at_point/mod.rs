//! The primitive joint that keeps two origins together.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
