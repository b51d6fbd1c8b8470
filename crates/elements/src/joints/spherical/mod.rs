//! A spherical joint: the origins stay together.

pub mod schema;
pub use schema::CLASS;
