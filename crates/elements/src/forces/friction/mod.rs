//! Friction in a joint.

pub mod schema;
pub use schema::CLASS;
