//! The comments of a command file, for whoever keeps or formats them; statements do not hold them.

use text::{FileId, Span};

use super::cursor::{Closing, closing, is_blank, line_end};
use crate::quoted::{end_of_string, end_of_value_string};

/// A comment from its `!` to the end of the line, blanks at the end left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comment {
    pub span: Span,
    /// Nothing but blanks stands before it.
    pub own_line: bool,
}

/// Iterator over the comments of a text, in order.
#[derive(Debug)]
pub struct Comments<'a> {
    file: FileId,
    bytes: &'a [u8],
    pos: usize,
}

/// All comments of a text.
pub fn comments(file: FileId, text: &str) -> Comments<'_> {
    Comments { file, bytes: text.as_bytes(), pos: if text.starts_with('\u{feff}') { 3 } else { 0 } }
}

impl Iterator for Comments<'_> {
    type Item = Comment;

    fn next(&mut self) -> Option<Comment> {
        let mut own_line = true; // between calls the position is at the start of a line
        let mut in_word = false;
        while let Some(&b) = self.bytes.get(self.pos) {
            let at = self.pos;
            match b {
                b'\n' => {
                    own_line = true;
                    in_word = false;
                    self.pos += 1;
                    continue;
                }
                b'!' => {
                    let line_end = line_end(self.bytes, at);
                    self.pos = (line_end + 1).min(self.bytes.len());
                    let blanks = self.bytes[at..line_end].iter().rev().take_while(|b| is_blank(**b)).count();
                    return Some(Comment { span: Span::new(self.file, at, line_end - blanks), own_line });
                }
                b'(' => {
                    self.pos = match closing(self.bytes, at, self.bytes.len()) {
                        Closing::At(close) => close + 1,
                        Closing::Missing | Closing::QuoteOpen(_) => line_end(self.bytes, at),
                    }
                }
                b'"' | b'\'' if !in_word => self.skip(at, end_of_value_string(self.bytes, at)),
                b'"' => self.skip(at, end_of_string(self.bytes, at, self.bytes.len())),
                _ => self.pos += 1,
            }
            own_line &= is_blank(b);
            in_word = !(is_blank(b) || matches!(b, b'=' | b',' | b'(' | b')'));
        }
        None
    }
}

impl Comments<'_> {
    fn skip(&mut self, at: usize, end: Option<usize>) {
        self.pos = end.unwrap_or_else(|| line_end(self.bytes, at));
    }
}
