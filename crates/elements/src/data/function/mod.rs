//! A function of the user's own for expressions.

pub mod schema;
pub use schema::CLASS;
