//! The section of a solid circle.

pub mod schema;
pub use schema::CLASS;
