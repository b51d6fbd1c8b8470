//! The settings of static equilibrium.

pub mod schema;
pub use schema::CLASS;
