//! A translational joint: I slides along z of J.

pub mod schema;
pub use schema::CLASS;
