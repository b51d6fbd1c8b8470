//! A variable of the solver.

pub mod schema;
pub use schema::CLASS;
