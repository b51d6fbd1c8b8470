//! A Hooke joint: a universal joint given by its shafts.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
