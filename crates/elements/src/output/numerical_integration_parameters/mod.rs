//! The settings of the time integrator.

pub mod schema;
pub use schema::CLASS;
