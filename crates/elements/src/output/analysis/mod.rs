//! An analysis: what owns the results of a run.

pub mod schema;
pub use schema::CLASS;
