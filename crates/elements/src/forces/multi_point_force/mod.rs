//! A linear force between several markers and one, through matrices.

pub mod schema;
pub use schema::CLASS;
