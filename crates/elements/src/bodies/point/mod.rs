//! A design point: a place that other objects refer to.

pub mod schema;
pub use schema::CLASS;
