//! A curve in space that constraints and graphics follow.

pub mod schema;
pub use schema::CLASS;
