//! A rigid part: mass, and the frame in which its markers are placed.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
