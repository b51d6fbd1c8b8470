//! Lexers, grammars and trees. No command and no element is named here.
//!
//! Every grammar yields a tree *and* a list of diagnostics, always both, whatever the input.

pub mod command;
pub mod function;
