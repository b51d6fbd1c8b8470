//! Lines of a dataset to statements: what belongs together, and which comments belong to it.
//!
//! A comment belongs to the statement it stands in or before. What only arranges the page is none:
//! banners, lone marks, the name and the units of an object, and what our writer says it left out.
//! A statement behind comment marks, below the name of its object, is an object that is switched off.

use std::ops::Range;

use text::{Diagnostic, FileId, Span};

/// What ends the comments of the model.
pub(crate) const END_OF_MODEL_COMMENTS: &str = "END OF MODEL COMMENTS";
/// What a comment of the writer about something left out begins with.
pub(crate) const NOT_WRITTEN: &str = " not written: ";

/// A statement as its lines: head (`MARKER/7`) and the text behind it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Block {
    /// Source ranges without comments; of all but the first, what follows the leading comma.
    pub pieces: Vec<Range<usize>>,
    pub comments: Vec<String>,
    pub view_name: Option<String>,
    pub view_units: Option<String>,
    pub inactive: bool,
}

/// A dataset as blocks.
#[derive(Debug, Default)]
pub(crate) struct Blocks {
    pub title: String,
    pub model_comments: Vec<String>,
    pub list: Vec<Block>,
    /// Comments behind the last statement.
    pub trailing: Vec<String>,
    /// Lines behind END that begin like a statement.
    pub behind_end: Vec<Range<usize>>,
    pub diagnostics: Vec<Diagnostic>,
}

pub(crate) fn blocks(file: FileId, text: &str) -> Blocks {
    let mut reader =
        Lines { file, found: Blocks::default(), waiting: Waiting::default(), open: None, broken_off: None };
    let mut offset = 0;
    let mut ended = false;
    for (index, line) in text.split_inclusive(['\n', '\r']).enumerate() {
        let start = offset;
        offset += line.len();
        let line = line.trim_end_matches(['\n', '\r']);
        if ended {
            let content = line.trim();
            if begins_statement(content) {
                let at = start + line.len() - line.trim_start().len();
                reader.found.behind_end.push(at..at + content.len());
            }
        } else if index == 0 {
            reader.found.title = line.trim_start_matches('\u{feff}').to_string();
        } else {
            ended = reader.line(line, start);
        }
    }
    reader.close();
    reader.close_inactive();
    reader.waiting.give_up_name();
    reader.found.trailing = std::mem::take(&mut reader.waiting.comments).list;
    if !ended {
        let end = Span::new(file, text.len(), text.len());
        let missing = Diagnostic::warning("dataset/missing-end", "the dataset has no END")
            .at(end, "END is missing")
            .help("if the file is complete, add a line `END`");
        reader.found.diagnostics.push(missing);
    }
    reader.found
}

/// Comments in order. Lone marks count where they stand between two lines of text that belong together.
#[derive(Debug, Default)]
struct Comments {
    list: Vec<String>,
    lone: usize,
}

impl Comments {
    fn add(&mut self, comment: String) {
        if self.list.last().is_some_and(|last| last.trim() != END_OF_MODEL_COMMENTS) {
            self.list.extend(std::iter::repeat_n(String::new(), self.lone));
        }
        self.lone = 0;
        self.list.push(comment);
    }

    /// Something of the page's layout stands here.
    fn interrupt(&mut self) {
        self.lone = 0;
    }
}

/// What waits for the statement it belongs to.
#[derive(Debug, Default)]
struct Waiting {
    comments: Comments,
    view_name: Option<String>,
    view_units: Option<String>,
    /// Lines of a statement behind comment marks.
    inactive: Option<Vec<Range<usize>>>,
    /// Where among the comments the name stands.
    name_at: usize,
    /// The name of the object was the last thing read.
    named: bool,
}

impl Waiting {
    /// A name that turns out to name nothing is a comment.
    fn give_up_name(&mut self) {
        let at = self.name_at.min(self.comments.list.len());
        if let Some(units) = self.view_units.take() {
            self.comments.list.insert(at, format!("adams_view_units='{units}'"));
        }
        if let Some(name) = self.view_name.take() {
            self.comments.list.insert(at, format!("adams_view_name='{name}'"));
        }
        self.named = false;
    }
}

struct Lines {
    file: FileId,
    found: Blocks,
    waiting: Waiting,
    open: Option<Block>,
    /// What the last line of the open statement breaks off at, where something must follow.
    broken_off: Option<char>,
}

impl Lines {
    /// Takes a line; true at END.
    fn line(&mut self, line: &str, start: usize) -> bool {
        let (content, comment) = split_comment(line);
        let trimmed = content.trim_start();
        let at = start + content.len() - trimmed.len();
        let trimmed = trimmed.trim_end();
        if trimmed.eq_ignore_ascii_case("END") {
            self.inline(comment);
            return true;
        }
        if trimmed.eq_ignore_ascii_case("LIST") || trimmed.eq_ignore_ascii_case("NOLIST") {
            // Whether the solver echoes its input: nothing to a model.
            self.close();
            self.inline(comment);
        } else if let Some(rest) = trimmed.strip_prefix(',') {
            self.close_inactive();
            self.continuation(at + 1..at + 1 + rest.len());
            self.inline(comment);
        } else if trimmed.is_empty() {
            if let Some(comment) = comment {
                self.comment(comment, start + line.len() - comment.len());
            }
        } else {
            let goes_on = self.broken_off.is_some() || begins_argument(trimmed);
            if self.open.is_some() && goes_on && !begins_statement(trimmed) {
                self.without_comma(trimmed, at);
            } else {
                self.statements(trimmed, at);
            }
            self.inline(comment);
        }
        if !trimmed.is_empty() {
            self.broken_off = trimmed.chars().last().filter(|c| matches!(c, ',' | '&' | '+' | '-' | '*' | '('));
        }
        false
    }

    /// Statements of one line, one as a rule: old files part several by semicolons.
    fn statements(&mut self, mut text: &str, mut at: usize) {
        loop {
            let cut = text.match_indices(';').map(|(i, _)| i).find(|i| begins_statement(&text[i + 1..]));
            self.open(at..at + cut.unwrap_or(text.len()));
            let Some(cut) = cut else { return };
            let rest = text[cut + 1..].trim_start();
            at += text.len() - rest.len();
            text = rest;
        }
    }

    fn open(&mut self, piece: Range<usize>) {
        self.close();
        self.close_inactive();
        let waiting = std::mem::take(&mut self.waiting);
        let Waiting { comments, view_name, view_units, .. } = waiting;
        // Comments of the model come first and are ended in so many words.
        let mut comments = comments.list;
        if self.found.list.is_empty()
            && let Some(end) = comments.iter().rposition(|c| c.trim() == END_OF_MODEL_COMMENTS)
        {
            let rest = comments.split_off(end + 1);
            comments.pop();
            self.found.model_comments = std::mem::replace(&mut comments, rest);
        }
        self.open = Some(Block { pieces: vec![piece], comments, view_name, view_units, inactive: false });
    }

    fn continuation(&mut self, piece: Range<usize>) {
        if let Some(open) = &mut self.open {
            // What stands between the lines of a statement is within it.
            self.waiting.give_up_name();
            open.comments.extend(std::mem::take(&mut self.waiting).comments.list);
            open.pieces.push(piece);
        } else {
            let span = Span::new(self.file, piece.start - 1, piece.end);
            let stray = Diagnostic::error("dataset/stray-continuation", "a continued line without a statement")
                .at(span, "continues nothing")
                .help("a statement begins with its name and a slash: `MARKER/7`");
            self.found.diagnostics.push(stray);
        }
    }

    /// A line that goes on although no comma leads it.
    fn without_comma(&mut self, line: &str, at: usize) {
        let word = line.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.')).unwrap_or(line.len());
        let word = word.max(line.chars().next().map_or(0, char::len_utf8));
        let span = Span::new(self.file, at, at + word);
        let missing = Diagnostic::error("dataset/missing-comma", "a line that goes on begins with a comma");
        let mut missing = missing.at(span, "goes on from the line before");
        if self.broken_off == Some('&')
            && let Some(before) = self.open.as_mut().and_then(|open| open.pieces.last_mut())
        {
            before.end -= 1;
            missing = missing.note("`&` is for command files");
        }
        let begin = format!(", {}", &line[..word]);
        self.found.diagnostics.push(missing.fix(format!("write `{begin}`"), span, begin));
        self.close_inactive();
        self.continuation(at..at + line.len());
    }

    /// A comment behind text.
    fn inline(&mut self, comment: Option<&str>) {
        let Some(comment) = comment else { return };
        let comment = without_blank(comment).to_string();
        match &mut self.open {
            Some(open) => open.comments.push(comment),
            None => self.waiting.comments.add(comment),
        }
    }

    /// A line that is a comment; `start` is where its text begins.
    fn comment(&mut self, comment: &str, start: usize) {
        if let Some(lines) = &mut self.waiting.inactive {
            if let Some(rest) = comment.strip_prefix(',') {
                let rest = split_comment(rest).0.trim_end();
                lines.push(start + 1..start + 1 + rest.len());
                return;
            }
            self.close_inactive();
        }
        let waiting = &mut self.waiting;
        if waiting.named && begins_statement(comment) && !comment.starts_with(' ') {
            let end = start + split_comment(comment).0.trim_end().len();
            waiting.inactive.get_or_insert_default().push(start..end);
            return;
        }
        if let Some(name) = quoted(comment, "adams_view_name") {
            waiting.give_up_name();
            waiting.comments.interrupt();
            waiting.view_name = Some(name);
            waiting.name_at = waiting.comments.list.len();
            waiting.named = true;
        } else if let Some(units) = quoted(comment, "adams_view_units").filter(|_| waiting.named) {
            waiting.view_units = Some(units);
        } else if comment.is_empty() {
            waiting.comments.lone += 1;
        } else if comment.starts_with(NOT_WRITTEN) || is_banner(comment) {
            waiting.comments.interrupt();
        } else {
            waiting.named = false;
            waiting.comments.add(without_blank(comment).to_string());
        }
    }

    fn close(&mut self) {
        if let Some(block) = self.open.take() {
            self.found.list.push(block);
        }
    }

    fn close_inactive(&mut self) {
        let Some(pieces) = self.waiting.inactive.take() else { return };
        // It ends the statement before it.
        self.close();
        let waiting = std::mem::take(&mut self.waiting);
        let Waiting { comments, view_name, view_units, .. } = waiting;
        self.found.list.push(Block { pieces, comments: comments.list, view_name, view_units, inactive: true });
    }
}

/// Whether a text begins like a statement: `NAME/`.
pub(super) fn begins_statement(text: &str) -> bool {
    let text = text.trim_start();
    let word = text.len() - text.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len();
    word > 1 && text.starts_with(|c: char| c.is_ascii_alphabetic()) && text[word..].trim_start().starts_with('/')
}

/// Whether a text begins like an argument: `NAME =`.
fn begins_argument(text: &str) -> bool {
    let word = text.len() - text.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len();
    word > 0 && text[word..].trim_start().starts_with('=')
}

/// The blank our writer, and people, put behind the mark.
fn without_blank(comment: &str) -> &str {
    comment.strip_prefix(' ').unwrap_or(comment)
}

/// `---- PARTS ----`, directly behind the mark.
fn is_banner(comment: &str) -> bool {
    let line = |c: char| c == '-' || c == '=';
    let comment = comment.trim_end();
    let (before, behind) = (comment.trim_start_matches(line), comment.trim_end_matches(line));
    comment.len() - before.len() >= 4 && (before.is_empty() || comment.len() - behind.len() >= 4)
}

/// The text in `key='text'`.
fn quoted(comment: &str, key: &str) -> Option<String> {
    let rest = comment.trim().strip_prefix(key)?.trim_start().strip_prefix('=')?.trim_start();
    let inner = rest.strip_prefix('\'')?.strip_suffix('\'')?;
    (!inner.trim().is_empty()).then(|| inner.to_string())
}

/// A line without its comment, and the comment.
pub(crate) fn split_comment(line: &str) -> (&str, Option<&str>) {
    let mut in_quotes = false;
    for (at, byte) in line.bytes().enumerate() {
        match byte {
            b'"' => in_quotes = !in_quotes,
            b'!' if !in_quotes => return (&line[..at], Some(&line[at + 1..])),
            _ => {}
        }
    }
    // A quote that is not closed protects nothing.
    if in_quotes && let Some((content, comment)) = line.split_once('!') {
        return (content, Some(comment));
    }
    (line, None)
}
