//! A force and a torque of three components each, given by functions.

pub mod schema;
pub use schema::CLASS;
