//! Splits dataset text into statements: name, number, arguments with their places. What they mean
//! is not looked at yet.

use text::{Diagnostic, FileId, Span};

/// One argument of a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// As written: `I`, `REVOLUTE`.
    pub keyword: String,
    /// What stands behind `=`, continued lines joined by a blank; `None` for a bare word.
    pub value: Option<String>,
    pub span: Span,
}

/// One statement: `MARKER/0201, PART = 2, QP = 0, 6, 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// In capitals, as written otherwise (abbreviations are not expanded).
    pub name: String,
    pub id: Option<i64>,
    pub arguments: Vec<Argument>,
    /// Comment lines since the statement before, without the mark.
    pub comments: Vec<String>,
    /// Of the name of the object, from the comment `adams_view_name='...'`.
    pub view_name: Option<String>,
    pub span: Span,
}

impl Statement {
    /// The value of an argument by its full keyword, ignoring case.
    pub fn value(&self, keyword: &str) -> Option<&str> {
        self.arguments.iter().find(|a| a.keyword.eq_ignore_ascii_case(keyword))?.value.as_deref()
    }

    /// Whether a bare word is among the arguments.
    pub fn has(&self, word: &str) -> bool {
        self.arguments.iter().any(|a| a.value.is_none() && a.keyword.eq_ignore_ascii_case(word))
    }
}

/// A dataset split into statements.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Statements {
    /// The first line, whatever it says.
    pub title: String,
    pub statements: Vec<Statement>,
    pub diagnostics: Vec<Diagnostic>,
}

impl Statements {
    /// How many statements of a name there are.
    pub fn count(&self, name: &str) -> usize {
        self.statements.iter().filter(|s| s.name.eq_ignore_ascii_case(name)).count()
    }
}

/// Reads the text of a dataset up to `END`.
pub fn read_statements(file: FileId, text: &str) -> Statements {
    let mut reader = Reader { file, found: Statements::default(), comments: Vec::new(), open: None };
    let mut offset = 0;
    let mut ended = false;
    for (index, line) in text.split_inclusive('\n').enumerate() {
        let start = offset;
        offset += line.len();
        let line = line.trim_end_matches(['\n', '\r']);
        if index == 0 {
            reader.found.title = line.to_string();
            continue;
        }
        if reader.line(line, start) {
            ended = true;
            break;
        }
    }
    reader.close();
    if !ended {
        let end = Span::new(file, text.len(), text.len());
        let missing = Diagnostic::warning("dataset/missing-end", "the dataset has no END").at(end, "END is missing");
        reader.found.diagnostics.push(missing);
    }
    reader.found
}

struct Reader {
    file: FileId,
    found: Statements,
    /// Comments since the last line of a statement: they belong to what follows.
    comments: Vec<String>,
    open: Option<Open>,
}

/// The statement being read.
struct Open {
    comments: Vec<String>,
    /// Text and offset of each line.
    pieces: Vec<(String, usize)>,
}

impl Reader {
    /// Takes a line; true at END.
    fn line(&mut self, line: &str, start: usize) -> bool {
        let (content, comment) = split_comment(line);
        let trimmed = content.trim_start();
        let start = start + content.len() - trimmed.len();
        let trimmed = trimmed.trim_end();
        if trimmed.eq_ignore_ascii_case("END") {
            return true;
        }
        if let Some(rest) = trimmed.strip_prefix(',') {
            self.continuation(rest, start);
        } else if !trimmed.is_empty() {
            self.close();
            let comments = std::mem::take(&mut self.comments);
            self.open = Some(Open { comments, pieces: vec![(trimmed.to_string(), start)] });
        }
        if let Some(comment) = comment.map(str::to_string) {
            match &mut self.open {
                Some(open) if !trimmed.is_empty() => open.comments.push(comment),
                _ => self.comments.push(comment),
            }
        }
        false
    }

    fn continuation(&mut self, rest: &str, start: usize) {
        if let Some(open) = &mut self.open {
            open.comments.append(&mut self.comments);
            open.pieces.push((rest.to_string(), start + 1));
        } else {
            let span = Span::new(self.file, start, start + 1 + rest.len());
            let stray = Diagnostic::error("dataset/stray-continuation", "a continued line without a statement");
            self.found.diagnostics.push(stray.at(span, "continues nothing"));
        }
    }

    fn close(&mut self) {
        let Some(Open { comments, pieces }) = self.open.take() else { return };
        if let Some(statement) = self.statement(&pieces, comments) {
            self.found.statements.push(statement);
        } else if let Some((text, start)) = pieces.first() {
            let span = Span::new(self.file, *start, start + text.len());
            let message = "a statement begins with a name and a slash";
            let wrong = Diagnostic::error("dataset/not-a-statement", message).at(span, "not a statement");
            self.found.diagnostics.push(wrong);
        }
    }

    fn statement(&self, pieces: &[(String, usize)], comments: Vec<String>) -> Option<Statement> {
        let (head, start) = pieces.first()?;
        let (name, rest) = head.split_once('/')?;
        let name = name.trim();
        if name.is_empty() || !name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
            return None;
        }
        let digits = rest.len() - rest.trim_start().trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let id = rest[..digits].trim().parse().ok();
        let at = start + head.len() - rest.len() + digits;
        let mut arguments = Vec::new();
        self.arguments(&rest[digits..], at, &mut arguments);
        for (piece, at) in &pieces[1..] {
            self.arguments(piece, *at, &mut arguments);
        }
        let end = pieces.last().map_or(start + head.len(), |(text, at)| at + text.len());
        let view_name = comments.iter().find_map(|c| view_name(c));
        let span = Span::new(self.file, *start, end);
        Some(Statement { name: name.to_ascii_uppercase(), id, arguments, comments, view_name, span })
    }

    /// Arguments of one line. Something without a keyword continues the value before it.
    fn arguments(&self, piece: &str, offset: usize, arguments: &mut Vec<Argument>) {
        for (start, end) in split_at_commas(piece) {
            let item = &piece[start..end];
            let trimmed = item.trim();
            if trimmed.is_empty() {
                continue;
            }
            let begin = offset + start + item.len() - item.trim_start().len();
            let span = Span::new(self.file, begin, begin + trimmed.len());
            if let Some((word, _)) = keyword(trimmed).filter(|(word, _)| takes_rest_of_line(word)) {
                let rest = piece[start..].trim();
                let value = rest.split_once('=').map(|(_, value)| value.trim().to_string());
                let span = Span::new(self.file, begin, begin + rest.len());
                arguments.push(Argument { keyword: word.to_string(), value, span });
                return;
            }
            match keyword(trimmed) {
                Some((word, value)) => {
                    let value = Some(value.trim().trim_end_matches('\\').trim_end().to_string());
                    arguments.push(Argument { keyword: word.to_string(), value, span });
                }
                None => match arguments.last_mut() {
                    // A bare word stands alone unless a value is being continued.
                    Some(Argument { value: Some(value), span: all, keyword }) if continues(keyword, value, trimmed) => {
                        let comma = if start > 0 || !is_function(keyword) { ", " } else { " " };
                        if !value.is_empty() {
                            value.push_str(comma);
                        }
                        value.push_str(trimmed.trim_end_matches('\\').trim_end());
                        *all = all.to(span);
                    }
                    _ => {
                        let word = trimmed.trim_end_matches('\\').trim_end();
                        arguments.push(Argument { keyword: word.to_string(), value: None, span });
                    }
                },
            }
        }
    }
}

/// Text that may hold commas itself.
fn takes_rest_of_line(keyword: &str) -> bool {
    ["COMMENT", "STRING", "C"].iter().any(|word| keyword.eq_ignore_ascii_case(word))
}

/// Whether a keyword takes an expression, in which the comma that leads a line is no part.
fn is_function(keyword: &str) -> bool {
    let upper = keyword.to_ascii_uppercase();
    ["FUNCTION", "FUN", "FX", "FY", "FZ", "TX", "TY", "TZ", "EVALUATE"].contains(&upper.as_str())
        || (upper.len() == 2 && upper.starts_with('F') && upper.ends_with(|c: char| c.is_ascii_digit()))
}

/// Whether an item without `=` belongs to the value before it: numbers, quoted strings, pieces of
/// an expression. A plain word is an argument of its own.
fn continues(keyword: &str, value: &str, item: &str) -> bool {
    let word = item.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
        && item.starts_with(|c: char| c.is_ascii_alphabetic());
    value.is_empty() || is_function(keyword) || !word
}

/// `KEYWORD = value`; `None` if there is no equals sign behind a plain word.
fn keyword(item: &str) -> Option<(&str, &str)> {
    let (word, value) = item.split_once('=')?;
    let word = word.trim();
    (!word.is_empty() && word.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')).then_some((word, value))
}

/// Byte ranges between commas outside parentheses and quotes.
fn split_at_commas(text: &str) -> Vec<(usize, usize)> {
    let (mut ranges, mut start, mut depth, mut quoted) = (Vec::new(), 0, 0usize, false);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b'(' if !quoted => depth += 1,
            b')' if !quoted => depth = depth.saturating_sub(1),
            b',' if !quoted && depth == 0 => {
                ranges.push((start, at));
                start = at + 1;
            }
            _ => {}
        }
    }
    ranges.push((start, text.len()));
    ranges
}

/// A line without its comment, and the comment.
fn split_comment(line: &str) -> (&str, Option<&str>) {
    let mut quoted = false;
    for (at, byte) in line.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b'!' if !quoted => return (&line[..at], Some(&line[at + 1..])),
            _ => {}
        }
    }
    (line, None)
}

fn view_name(comment: &str) -> Option<String> {
    let rest = comment.trim().strip_prefix("adams_view_name='")?;
    rest.strip_suffix('\'').map(str::to_string)
}
