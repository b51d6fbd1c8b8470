//! A translational joint: I slides along z of J.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
