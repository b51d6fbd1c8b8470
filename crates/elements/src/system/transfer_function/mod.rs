//! A linear system as a ratio of polynomials.

pub mod schema;
pub use schema::CLASS;
