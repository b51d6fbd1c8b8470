//! A measure of a quantity of one object.

pub mod schema;
pub use schema::CLASS;
