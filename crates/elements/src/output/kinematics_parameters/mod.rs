//! The settings of kinematic analysis.

pub mod schema;
pub use schema::CLASS;
