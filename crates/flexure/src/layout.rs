//! The layout of a command file as bytes: in whatever encoding it was written, what is not layout
//! comes back byte for byte.

use text::{Diagnostic, FileId, Sources};

/// A command file or macro and its layout.
#[derive(Debug)]
pub struct Layout {
    sources: Sources,
    file: FileId,
    after: String,
    diagnostics: Vec<Diagnostic>,
    /// The bytes are no UTF-8; each stands for the character of its number.
    one_byte_each: bool,
}

impl Layout {
    /// Lays out a file; its name appears in diagnostics.
    pub fn of(name: &str, bytes: Vec<u8>) -> Layout {
        let (text, one_byte_each) = match String::from_utf8(bytes) {
            Ok(text) => (text, false),
            Err(error) => (error.into_bytes().into_iter().map(char::from).collect(), true),
        };
        let mut sources = Sources::default();
        let file = sources.add(name, text);
        let formatted = syntax::command::format(file, sources.text(file));
        Layout { sources, file, after: formatted.text, diagnostics: formatted.diagnostics, one_byte_each }
    }

    /// Whether the layout differs.
    pub fn changed(&self) -> bool {
        self.before() != self.after
    }

    pub fn before(&self) -> &str {
        self.sources.text(self.file)
    }

    pub fn after(&self) -> &str {
        &self.after
    }

    /// The new text in the encoding of the old one.
    pub fn bytes(&self) -> Vec<u8> {
        if self.one_byte_each {
            // Every character came from a byte, and layout adds only ASCII.
            return self.after.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect();
        }
        self.after.clone().into_bytes()
    }

    /// Why statements were left as they are.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    pub fn sources(&self) -> &Sources {
        &self.sources
    }
}
