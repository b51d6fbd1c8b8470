//! A measure of a quantity of one object.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
