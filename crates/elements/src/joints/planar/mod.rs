//! A planar joint: I slides in the xy plane of J.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
