//! A measure of a function of time and state.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
