//! The symbol of a spring with a damper between two markers.

pub mod draw;
pub mod schema;
pub use schema::CLASS;
