//! A cylinder.

pub mod schema;
pub use schema::CLASS;
