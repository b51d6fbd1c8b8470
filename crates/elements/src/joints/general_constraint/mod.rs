//! A constraint that keeps a function of the state at zero.

pub mod schema;
pub use schema::CLASS;
