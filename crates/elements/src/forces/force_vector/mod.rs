//! A force of three components given by functions.

pub mod schema;
pub use schema::CLASS;
