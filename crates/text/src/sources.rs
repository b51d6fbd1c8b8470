//! The store of source files and the spans that point into them.

use std::sync::{Arc, OnceLock};

/// Index of a file in [`Sources`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(pub u32);

/// Half-open byte range `start..end` of one file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    pub file: FileId,
    pub start: u32,
    pub end: u32,
}

impl Span {
    pub fn new(file: FileId, start: usize, end: usize) -> Self {
        Span { file, start: start as u32, end: end as u32 }
    }

    /// The smallest span that covers both.
    #[must_use]
    pub fn to(self, other: Span) -> Span {
        debug_assert_eq!(self.file, other.file, "a span covers one file");
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }

    pub fn is_empty(self) -> bool {
        self.start == self.end
    }
}

/// Line and column, both counted from 1; columns count characters, not bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineColumn {
    pub line: usize,
    pub column: usize,
}

/// One text with its name.
#[derive(Debug)]
pub struct Source {
    name: String,
    text: String,
    /// Offsets at which lines begin; found when a line is first asked for.
    line_starts: OnceLock<Vec<u32>>,
}

impl Source {
    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    /// Offsets at which physical lines begin, the first of them 0.
    pub fn line_starts(&self) -> &[u32] {
        self.line_starts.get_or_init(|| {
            let breaks = self.text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i as u32 + 1);
            std::iter::once(0).chain(breaks).collect()
        })
    }

    /// The line of an offset, counted from 0.
    pub fn line_number(&self, offset: u32) -> usize {
        self.line_starts().partition_point(|&start| start <= offset) - 1
    }

    /// Byte range of the line that contains an offset, without its line break.
    pub fn line_range(&self, offset: u32) -> std::ops::Range<usize> {
        let line_starts = self.line_starts();
        let line = self.line_number(offset);
        let start = line_starts[line] as usize;
        let end = line_starts.get(line + 1).map_or(self.text.len(), |&next| next as usize - 1);
        let carriage_return = self.text.as_bytes().get(start..end).is_some_and(|line| line.ends_with(b"\r"));
        start..end - usize::from(carriage_return)
    }

    pub fn line_column(&self, offset: u32) -> LineColumn {
        let line = self.line_number(offset);
        let start = self.line_starts()[line] as usize;
        let end = (offset as usize).min(self.text.len());
        let column = self.text.get(start..end).map_or(end - start, |t| t.chars().count()) + 1;
        LineColumn { line: line + 1, column }
    }
}

/// All texts read in this session: files, command lines typed, macros.
#[derive(Debug, Default)]
pub struct Sources {
    files: Vec<Arc<Source>>,
}

impl Sources {
    /// Adds a text under a display name (a path, `<command line>`, ...).
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        let source = Source { name: name.into(), text: text.into(), line_starts: OnceLock::new() };
        self.files.push(Arc::new(source));
        FileId(self.files.len() as u32 - 1)
    }

    /// Adds bytes as UTF-8 or, where they are not, as Windows code page 1252 (what old Adams
    /// exports are written in).
    pub fn add_bytes(&mut self, name: impl Into<String>, bytes: Vec<u8>) -> FileId {
        let text =
            String::from_utf8(bytes).unwrap_or_else(|e| e.into_bytes().iter().map(|&b| windows_1252(b)).collect());
        self.add(name, text)
    }

    /// A text to hold on to while others are added.
    pub fn share(&self, file: FileId) -> Arc<Source> {
        self.files[file.0 as usize].clone()
    }

    /// The first text that was added under a name.
    pub fn find(&self, name: &str) -> Option<FileId> {
        self.files.iter().position(|source| source.name() == name).map(|at| FileId(at as u32))
    }

    pub fn name(&self, file: FileId) -> &str {
        self.files[file.0 as usize].name()
    }

    pub fn text(&self, file: FileId) -> &str {
        self.files[file.0 as usize].text()
    }

    /// The text a span covers.
    pub fn slice(&self, span: Span) -> &str {
        &self.text(span.file)[span.range()]
    }

    /// Byte range of the line that contains an offset, without its line break.
    pub fn line_range(&self, file: FileId, offset: u32) -> std::ops::Range<usize> {
        self.files[file.0 as usize].line_range(offset)
    }

    pub fn line_column(&self, file: FileId, offset: u32) -> LineColumn {
        self.files[file.0 as usize].line_column(offset)
    }
}

/// The character of a byte in Windows code page 1252; undefined bytes map to themselves.
fn windows_1252(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘',
        '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => HIGH[(byte - 0x80) as usize],
        _ => char::from(byte),
    }
}

/// A text in Windows code page 1252; none if it has a character that is not in it.
pub fn to_windows_1252(text: &str) -> Option<Vec<u8>> {
    text.chars().map(|c| (0..=255).find(|byte| windows_1252(*byte) == c)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_lines_and_characters_from_one() {
        let mut sources = Sources::default();
        let file = sources.add("a.cmd", "é = 1\nab\n");
        assert_eq!(sources.line_column(file, 0), LineColumn { line: 1, column: 1 });
        assert_eq!(sources.line_column(file, 3), LineColumn { line: 1, column: 3 });
        assert_eq!(sources.line_column(file, 8), LineColumn { line: 2, column: 2 });
    }

    #[test]
    fn a_line_is_given_without_its_line_break() {
        let mut sources = Sources::default();
        let file = sources.add("a.cmd", "ab\r\n\nc");
        let lines: Vec<_> = (0..=6).map(|at| sources.line_range(file, at)).collect();
        assert_eq!(lines, [0..2, 0..2, 0..2, 0..2, 4..4, 5..6, 5..6]);
    }

    #[test]
    fn bytes_that_are_not_utf8_are_read_as_code_page_1252() {
        let mut sources = Sources::default();
        let file = sources.add_bytes("a.cmd", vec![b'!', 0xe4, 0x80]);
        assert_eq!(sources.text(file), "!ä€");
        assert_eq!(to_windows_1252("!ä€"), Some(vec![b'!', 0xe4, 0x80]));
        assert_eq!(to_windows_1252("λ"), None);
        let all: Vec<u8> = (0..=255).collect();
        let file = sources.add_bytes("b.cmd", all.clone());
        assert_eq!(to_windows_1252(sources.text(file)), Some(all));
    }
}
