//! A shell.
#![doc = include_str!("docs.md")]

pub mod schema;
pub use schema::CLASS;
