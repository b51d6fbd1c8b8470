//! The primitive joint that keeps two origins together.

pub mod schema;
pub use schema::CLASS;
