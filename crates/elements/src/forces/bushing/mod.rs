//! A bushing: springs and dampers along and about three axes, without coupling.
#![doc = include_str!("docs.md")]

pub mod lower;
pub mod physics;
pub mod schema;
pub use schema::CLASS;
