//! A coupler: the coordinates of two or three joints are proportional.

pub mod schema;
pub use schema::CLASS;
