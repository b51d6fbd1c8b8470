//! A motion: a joint or two markers driven by a function.

mod integral;
pub mod lower;
pub mod schema;
pub use schema::CLASS;
