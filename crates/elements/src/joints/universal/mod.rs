//! A universal joint: the z axes are the pins of a cross.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
