//! A simulation script: what a scripted run does.

pub mod schema;
pub use schema::CLASS;
