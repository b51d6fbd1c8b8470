//! A fixed joint: two markers stay one.

pub mod lower;
pub mod schema;
pub use schema::CLASS;
