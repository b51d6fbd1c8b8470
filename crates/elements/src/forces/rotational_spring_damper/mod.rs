//! A spring and damper about the common z axis of two markers.

pub mod schema;
pub use schema::CLASS;
