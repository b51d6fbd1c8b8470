//! A model: what everything else is part of.

pub mod schema;
pub use schema::CLASS;
