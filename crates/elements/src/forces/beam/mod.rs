//! A massless elastic beam between two markers.

pub mod schema;
pub use schema::CLASS;
