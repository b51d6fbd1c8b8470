//! A force along a line, or a torque about an axis, given by a function.

pub mod element;
pub mod lower;
pub mod schema;
pub use schema::CLASS;
