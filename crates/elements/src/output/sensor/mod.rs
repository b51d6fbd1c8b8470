//! A sensor: acts when a function reaches a limit.

pub mod schema;
pub use schema::CLASS;
