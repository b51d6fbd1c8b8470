//! A system of states that subroutines of the user evaluate.

pub mod schema;
pub use schema::CLASS;
