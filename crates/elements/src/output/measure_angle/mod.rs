//! A measure of an angle.

pub mod schema;
pub use schema::CLASS;
