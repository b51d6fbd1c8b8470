//! The lexer: walks the bytes of a command file, knows blanks, comments, continuation marks, words
//! and matching brackets. It owns no tokens; the parser asks for what it expects next.

use crate::quoted::{end_of_string, end_of_value_string};

const BLANK: u8 = 1;
/// Ends a word outside quotes and wildcard brackets.
const ENDS_WORD: u8 = 2;
/// May stand in a name inside an expression.
const NAME: u8 = 4;
/// Control characters, which no command file contains on purpose.
const CONTROL: u8 = 8;

const CLASS: [u8; 256] = {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let b = i as u8;
        table[i] = match b {
            b' ' | b'\t' | b'\r' | 0x0b | 0x0c => BLANK | ENDS_WORD,
            b'\n' | b'=' | b',' | b'(' | b')' | b'!' | b'&' => ENDS_WORD,
            b'_' | b'$' | b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | 0x80..=0xff => NAME,
            0..=0x1f | 0x7f => CONTROL | ENDS_WORD,
            _ => 0,
        };
        i += 1;
    }
    table
};

pub(crate) fn is_blank(b: u8) -> bool {
    CLASS[b as usize] & BLANK != 0
}

pub(crate) fn is_name(b: u8) -> bool {
    CLASS[b as usize] & NAME != 0
}

pub(crate) fn is_control(b: u8) -> bool {
    CLASS[b as usize] & CONTROL != 0
}

/// What stands before the next token of the same statement, or why there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gap {
    Token,
    /// The physical line ended and was not continued.
    EndOfLine,
    /// A continuation mark was followed by an empty line.
    EmptyLine,
    EndOfFile,
}

/// Where a bracket that was opened gets closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Closing {
    /// Offset of the closing bracket.
    At(usize),
    /// The line ends inside the bracket.
    Missing,
    /// The line ends inside the string that opens here.
    QuoteOpen(usize),
}

#[derive(Debug)]
pub(super) struct Cursor<'a> {
    pub text: &'a str,
    pub bytes: &'a [u8],
    pub pos: usize,
    /// Set once the end of the current statement has been passed.
    pub end: Option<Gap>,
}

impl<'a> Cursor<'a> {
    pub fn new(text: &'a str) -> Self {
        let pos = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Cursor { text, bytes: text.as_bytes(), pos, end: None }
    }

    pub fn peek(&self) -> Option<u8> {
        self.bytes.get(self.pos).copied()
    }

    /// Moves to the first token of the next statement; false at the end of the file.
    pub fn begin_statement(&mut self) -> bool {
        self.end = None;
        loop {
            match self.peek() {
                None => return false,
                Some(b'\n') => self.pos += 1,
                Some(b'!') => self.pos = self.line_end(self.pos),
                Some(b) if is_blank(b) => self.pos += 1,
                // A mark with nothing before it continues nothing.
                Some(b'&') if self.is_continuation(self.pos) => self.pos = self.line_end(self.pos),
                Some(_) => return true,
            }
        }
    }

    /// Moves over blanks, continuation marks and comments to the next token of the statement.
    pub fn skip_gap(&mut self) -> Gap {
        if let Some(end) = self.end {
            return end;
        }
        loop {
            match self.peek() {
                Some(b' ') => self.pos += 1,
                Some(b'\n') => {
                    self.pos += 1;
                    return self.ends(Gap::EndOfLine);
                }
                Some(b'!') => self.pos = self.line_end(self.pos),
                Some(b'&') => {
                    if !self.is_continuation(self.pos) {
                        return Gap::Token;
                    }
                    if let Some(end) = self.next_continued_line() {
                        return self.ends(end);
                    }
                }
                Some(b) if is_blank(b) => self.pos += 1,
                Some(_) => return Gap::Token,
                None => return self.ends(Gap::EndOfFile),
            }
        }
    }

    fn ends(&mut self, gap: Gap) -> Gap {
        self.end = Some(gap);
        gap
    }

    /// From a continuation mark to the next line that has more than a comment on it.
    fn next_continued_line(&mut self) -> Option<Gap> {
        self.pos = (self.line_end(self.pos) + 1).min(self.bytes.len());
        loop {
            while self.peek().is_some_and(is_blank) {
                self.pos += 1;
            }
            match self.peek() {
                None => return Some(Gap::EndOfFile),
                Some(b'\n') => {
                    self.pos += 1;
                    return Some(Gap::EmptyLine);
                }
                Some(b'!') => self.pos = (self.line_end(self.pos) + 1).min(self.bytes.len()),
                Some(_) => return None,
            }
        }
    }

    /// After `name =` at the end of a line: goes on in the next line if something is there.
    /// Adams needs a `&` here; the help pages print commands without it.
    pub fn join_next_line(&mut self) -> bool {
        if self.end != Some(Gap::EndOfLine) {
            return false;
        }
        let mut next = self.pos;
        while self.bytes.get(next).copied().is_some_and(is_blank) {
            next += 1;
        }
        if matches!(self.bytes.get(next), None | Some(b'\n' | b'!')) {
            return false;
        }
        let pos = std::mem::replace(&mut self.pos, next);
        let begins_an_argument =
            self.end_of_word().is_ok_and(|end| self.bytes[end..].iter().find(|b| !is_blank(**b)) == Some(&b'='));
        if begins_an_argument {
            self.pos = pos;
            return false;
        }
        self.end = None;
        true
    }

    /// Whether the `&` at `at` is the last thing on its line but for a comment.
    fn is_continuation(&self, at: usize) -> bool {
        self.bytes[at + 1..].iter().find(|b| !is_blank(**b)).is_none_or(|b| matches!(b, b'\n' | b'!'))
    }

    /// Offset of the line break that ends the physical line, or of the end of the file.
    pub fn line_end(&self, from: usize) -> usize {
        line_end(self.bytes, from)
    }

    /// Leaves the rest of the statement, with its continuation lines, unread.
    pub fn skip_statement(&mut self) {
        while self.end.is_none() {
            match self.skip_gap() {
                Gap::Token => self.pos = self.skip_token(),
                _ => return,
            }
        }
    }

    /// Offset behind whatever token starts here, for recovery only.
    fn skip_token(&self) -> usize {
        let at = self.pos;
        match self.bytes[at] {
            b'(' => match self.closing(at) {
                Closing::At(close) => close + 1,
                Closing::Missing | Closing::QuoteOpen(_) => self.unclosed_end(at),
            },
            b'"' | b'\'' => end_of_value_string(self.bytes, at).unwrap_or_else(|| self.unclosed_end(at)),
            _ => at + self.text[at..].chars().next().map_or(1, char::len_utf8),
        }
    }

    /// Where a string or bracket that is never closed is taken to end: before the continuation
    /// mark at the end of the line, or at the end of the line.
    pub fn unclosed_end(&self, from: usize) -> usize {
        let mut end = self.line_end(from);
        let trim = |mut end: usize| {
            while end > from + 1 && is_blank(self.bytes[end - 1]) {
                end -= 1;
            }
            end
        };
        end = trim(end);
        if end > from + 1 && self.bytes[end - 1] == b'&' {
            end = trim(end - 1);
        }
        end
    }

    /// Where the parenthesis that opens at `at` is closed on its line.
    pub fn closing(&self, at: usize) -> Closing {
        closing(self.bytes, at, self.bytes.len())
    }

    /// Offset behind the word that starts here, or the quote in it that is never closed.
    /// Quoted parts of dotted names and wildcard brackets belong to the word.
    pub fn end_of_word(&self) -> Result<usize, usize> {
        let mut i = self.pos;
        let mut brackets = true;
        while let Some(&b) = self.bytes.get(i) {
            if CLASS[b as usize] & ENDS_WORD != 0 {
                break;
            }
            i = match b {
                b'"' => end_of_string(self.bytes, i, self.bytes.len()).ok_or(i)?,
                b'{' | b'[' if brackets => {
                    let close = end_of_wildcard(self.bytes, i);
                    brackets = close.is_some(); // one failure is enough, else hostile input costs n^2
                    close.unwrap_or(i + 1)
                }
                _ => i + 1,
            };
        }
        Ok(i)
    }
}

/// Offset behind the bracket that closes the wildcard `{a,b}` or `[abc]`, which contains no blank.
fn end_of_wildcard(bytes: &[u8], at: usize) -> Option<usize> {
    let close = if bytes[at] == b'{' { b'}' } else { b']' };
    let end = bytes[at..].iter().position(|b| *b == close || *b == b'\n' || is_blank(*b))?;
    (bytes[at + end] == close).then_some(at + end + 1)
}

pub(crate) fn line_end(bytes: &[u8], from: usize) -> usize {
    bytes[from..].iter().position(|b| *b == b'\n').map_or(bytes.len(), |n| from + n)
}

/// Finds the parenthesis that closes the one at `at` before the line ends, not looking into strings.
pub(crate) fn closing(bytes: &[u8], at: usize, end: usize) -> Closing {
    let mut depth = 0_usize;
    let mut i = at;
    while i < end {
        match bytes[i] {
            b'(' => depth += 1,
            b')' => {
                depth -= 1;
                if depth == 0 {
                    return Closing::At(i);
                }
            }
            b'\n' => return Closing::Missing,
            b'"' | b'\'' => match end_of_string(bytes, i, end) {
                Some(after) => i = after - 1,
                None => return Closing::QuoteOpen(i),
            },
            _ => {}
        }
        i += 1;
    }
    Closing::Missing
}
