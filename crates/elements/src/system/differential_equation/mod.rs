//! A state of the user with its differential equation.

pub mod schema;
pub use schema::CLASS;
