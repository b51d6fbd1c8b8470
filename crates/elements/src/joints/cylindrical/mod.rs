//! A cylindrical joint: I slides along and turns about z of J.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
