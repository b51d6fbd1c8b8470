//! A universal joint: the z axes are the pins of a cross.

pub mod schema;
pub use schema::CLASS;
