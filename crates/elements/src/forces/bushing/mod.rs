//! A bushing: springs and dampers along and about three axes, without coupling.

pub mod schema;
pub use schema::CLASS;
