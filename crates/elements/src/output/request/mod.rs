//! A request: what is recorded during a run.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
