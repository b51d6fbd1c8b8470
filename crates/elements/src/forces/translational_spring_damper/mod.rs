//! A spring and damper along the line between two markers.

pub mod schema;
pub use schema::CLASS;
