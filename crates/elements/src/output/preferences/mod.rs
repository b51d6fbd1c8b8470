//! The preferences of the solver.

pub mod schema;
pub use schema::CLASS;
