//! A design variable: a value that expressions refer to.

pub mod schema;
pub use schema::CLASS;
