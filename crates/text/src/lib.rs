//! Files, positions and diagnostics: the ground floor on which every other room stands.
//!
//! A [`Sources`] store owns the text of every file that was read; a [`Span`] points into it; a
//! [`Diagnostic`] says what is wrong where. Nothing here knows a grammar.

mod diagnostic;
pub mod render;
mod sources;
mod suggest;

pub use diagnostic::{Diagnostic, Fix, Help, Label, Severity};
pub use render::{Format, one_line, render, use_colours};
pub use sources::{FileId, LineColumn, Source, Sources, Span, to_windows_1252};
pub use suggest::suggest;
