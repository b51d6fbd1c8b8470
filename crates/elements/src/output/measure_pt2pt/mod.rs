//! A measure of the motion of one marker as seen from another.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
