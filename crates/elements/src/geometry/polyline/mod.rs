//! A polyline.

pub mod schema;
pub use schema::CLASS;
