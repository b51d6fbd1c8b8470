//! A motion: a joint or two markers driven by a function.

pub mod schema;
pub use schema::CLASS;
