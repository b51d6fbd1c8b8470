//! A measure that asks a dialog.

pub mod schema;
pub use schema::CLASS;
