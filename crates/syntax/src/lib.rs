//! Lexers, grammars and trees. No command and no element is named here.
//!
//! Every grammar yields a tree *and* a list of diagnostics, always both, whatever the input.

pub mod command;
pub mod function;

mod number;
mod quoted;

/// How deep parentheses, braces, signs and powers may nest. Every level costs stack, here and in
/// whoever walks the tree later.
pub const MAX_NESTING: u32 = 200;

/// How high a tree may grow. A long chain `a + b + c ...` is a high tree although nothing nests.
pub const MAX_HEIGHT: u32 = 1000;
