//! A spline: points through which a smooth function goes.

pub mod schema;
pub use schema::CLASS;
