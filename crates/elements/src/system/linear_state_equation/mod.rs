//! A linear system as four matrices.

pub mod schema;
pub use schema::CLASS;
