//! A rack and a pinion: the rack moves as the pinion turns.

pub mod schema;
pub use schema::CLASS;
