//! A string that the solver knows.

pub mod schema;
pub use schema::CLASS;
