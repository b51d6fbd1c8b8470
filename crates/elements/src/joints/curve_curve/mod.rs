//! Two curves that stay in touch.

pub mod schema;
pub use schema::CLASS;
