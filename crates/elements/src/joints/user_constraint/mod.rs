//! A constraint that a subroutine of the user evaluates.

pub mod schema;
pub use schema::CLASS;
