//! Files, positions and diagnostics: the ground floor on which every other room stands.
//!
//! A [`Sources`] store owns the text of every file that was read; a [`Span`] points into it; a
//! [`Diagnostic`] says what is wrong where. Nothing here knows a grammar.

mod diagnostic;
mod sources;

pub use diagnostic::{Diagnostic, Fix, Help, Label, Severity};
pub use sources::{FileId, LineColumn, Sources, Span};
