//! A spherical joint: the origins stay together.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
