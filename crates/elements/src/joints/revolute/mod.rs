//! A revolute joint: I turns about z of J.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
