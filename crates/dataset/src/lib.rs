//! Solver datasets: a model written as `.adm` text, and `.adm` text read as a model.
//!
//! [`write`] lays a model out as View exports do, [`read()`] makes a model of such text. Regular
//! statements follow from the schema both ways (the class names the statement, its fields the
//! arguments); the irregular ones have a file each under `statements/`. [`number_objects`] gives every
//! object its number in the solver's files. [`read_statements`] is the first step of reading: names,
//! numbers, comments and arguments with their places.

mod ids;
mod layout;
mod number;
mod read;
mod statements;
mod unit_words;
mod write;

pub use ids::number_objects;
pub use number::{Digits, number};
pub use read::{Argument, Loaded, Naming, Statement, Statements, looks_like_dataset, read, read_statements};
pub use write::{Mass, MassOf, Options, Written, write};
