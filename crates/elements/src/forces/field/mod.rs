//! A field element: six loads from six deformations through full matrices.

pub mod schema;
pub use schema::CLASS;
