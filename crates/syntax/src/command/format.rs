//! Layout of command files, as Adams View writes its own exports: keywords on the first line, one
//! `parameter = value` on each further line, blocks indented.
//!
//! Only blanks, line ends and continuation marks change. Words, strings and expressions stay as
//! they were typed, comments stay where they are, and a statement that is not understood keeps
//! every byte. The result is read again and compared before it is returned.

use text::{Diagnostic, FileId, Severity};

use super::StatementKind;
use super::layout::{INDENT, lay_out};
use super::pieces::{Placed, Statements, blank, gaps, same_but_for_layout};

/// A text in its layout, and what is to be said about it.
#[derive(Clone, Debug)]
pub struct Formatted {
    pub text: String,
    /// Why statements were left as they are.
    pub diagnostics: Vec<Diagnostic>,
}

/// Lays out a command file or macro.
pub fn format(file: FileId, text: &str) -> Formatted {
    let mut printer = Printer::new(text);
    let mut diagnostics = Vec::new();
    let mut roles = block_roles(file, text).into_iter().peekable();
    for (index, mut placed) in Statements::of(file, text).enumerate() {
        let role = roles.next_if(|(at, _)| *at == index).map(|(_, role)| role);
        printer.lines_before(placed.statement.span.start as usize);
        printer.statement(&placed, role);
        if placed.fixed {
            diagnostics.extend(placed.diagnostics.drain(..).filter(Diagnostic::is_error));
        }
    }
    printer.lines_before(text.len());
    let text_laid_out = printer.out;
    if same_but_for_layout(file, text, &text_laid_out) {
        return Formatted { text: text_laid_out, diagnostics };
    }
    // A forgotten quote can make the meaning of a line depend on the layout of later ones.
    diagnostics.push(
        Diagnostic::new(
            Severity::Warning,
            "format/left-alone",
            "this text is left as it is: laid out, it would be read differently",
        )
        .help("mend the statements that are not understood, then lay it out"),
    );
    Formatted { text: text.to_owned(), diagnostics }
}

/// What a statement does to the indentation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    Opens,
    Parts,
    Closes,
    /// Opens a block that nothing closes: it is not indented, but it is laid out like the others.
    Alone,
}

/// Statements that open, part and close blocks, by index.
fn block_roles(file: FileId, text: &str) -> Vec<(usize, Role)> {
    let mut roles: Vec<(usize, Role)> = Vec::new();
    let mut open: Vec<(usize, bool)> = Vec::new();
    let mut parts: Vec<(usize, usize)> = Vec::new();
    for (index, placed) in Statements::of(file, text).enumerate() {
        let StatementKind::Command { keywords, arguments } = &placed.statement.kind else { continue };
        let [word] = keywords.as_slice() else { continue };
        let word = &text[word.range()];
        let is = |all: &[&str]| all.iter().any(|w| word.eq_ignore_ascii_case(w));
        if is(&["if", "while", "for"]) && !arguments.is_empty() {
            open.push((roles.len(), is(&["if"])));
            roles.push((index, Role::Alone));
        } else if is(&["elseif"]) || is(&["else"]) && arguments.is_empty() {
            if let Some(&(opener, true)) = open.last() {
                parts.push((opener, roles.len()));
                roles.push((index, Role::Alone));
            }
        } else if is(&["end"])
            && arguments.is_empty()
            && !placed.fixed
            && let Some((opener, _)) = open.pop()
        {
            roles[opener].1 = Role::Opens;
            while let Some((_, part)) = parts.pop_if(|(of, _)| *of >= opener) {
                roles[part].1 = Role::Parts;
            }
            roles.push((index, Role::Closes));
        }
    }
    roles
}

/// How lines end: like the last one that holds something, which stays the last one.
fn line_end_of(text: &str) -> &'static str {
    let mut lines = text.split_inclusive('\n').rev();
    let last = lines.find(|line| !line.trim_matches(|c| blank(c) || c == '\n').is_empty());
    let of = match last {
        Some(line) if line.ends_with('\n') => line,
        _ => text.split_inclusive('\n').next().unwrap_or(""),
    };
    if of.ends_with("\r\n") { "\r\n" } else { "\n" }
}

struct Printer<'a> {
    text: &'a str,
    out: String,
    line_end: &'static str,
    /// Offset up to which the text has been printed.
    at: usize,
    depth: usize,
    /// An empty line is due before whatever comes next.
    empty_line: bool,
}

impl<'a> Printer<'a> {
    fn new(text: &'a str) -> Printer<'a> {
        let mut out = String::with_capacity(text.len() + text.len() / 8);
        let at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        out.push_str(&text[..at]);
        Printer { text, out, line_end: line_end_of(text), at, depth: 0, empty_line: false }
    }

    /// Comments and empty lines between statements.
    fn lines_before(&mut self, end: usize) {
        let between = &self.text[self.at..end];
        for line in between.split_inclusive('\n') {
            let inside = line.trim_matches(|c| blank(c) || c == '\n');
            if inside.is_empty() {
                // What is left of the last line is the indentation of the statement.
                self.empty_line |= line.ends_with('\n') && !self.out.trim_start_matches('\u{feff}').is_empty();
                continue;
            }
            self.begin_line(self.depth);
            // Headers of macros hold default values, and blanks at their end may be meant.
            let header = inside.starts_with("!$");
            let kept = if header { line.trim_start_matches(blank).trim_end_matches(['\n', '\r']) } else { inside };
            self.out.push_str(kept);
            self.end_line();
        }
        self.at = end;
    }

    fn begin_line(&mut self, depth: usize) {
        if std::mem::take(&mut self.empty_line) {
            self.out.push_str(self.line_end);
        }
        for _ in 0..depth * INDENT {
            self.out.push(' ');
        }
    }

    fn end_line(&mut self) {
        self.out.push_str(self.line_end);
    }

    fn statement(&mut self, placed: &Placed, role: Option<Role>) {
        if matches!(role, Some(Role::Parts | Role::Closes)) {
            self.depth = self.depth.saturating_sub(1);
        }
        let start = placed.statement.span.start as usize;
        self.at = placed.end;
        match gaps(self.text, &placed.statement, placed.end).filter(|_| !placed.fixed) {
            None => self.as_it_is(start, placed.end),
            Some(gaps) => {
                let sheet = lay_out(self.text, &placed.statement, &gaps, self.depth, role.is_some());
                for line in &sheet.lines {
                    self.begin_line(self.depth + line.indent);
                    self.out.push_str(&line.text);
                    self.end_line();
                }
                let behind = &self.text[..placed.end];
                let last_line = behind.strip_suffix('\n').unwrap_or(behind).rsplit('\n').next().unwrap_or("");
                // A continuation mark before an empty line: the line ended the statement.
                self.empty_line |= behind.ends_with('\n') && last_line.trim_matches(blank).is_empty();
            }
        }
        if matches!(role, Some(Role::Opens | Role::Parts)) {
            self.depth += 1;
        }
    }

    /// A statement that is not understood, with the blanks before it and the ends of its lines.
    fn as_it_is(&mut self, start: usize, end: usize) {
        self.begin_line(0);
        let before = &self.text[..start];
        let indentation = before.len() - before.trim_end_matches(blank).len();
        let raw = &self.text[start - indentation..end];
        let kept = raw.trim_end_matches(|c| blank(c) || c == '\n').len();
        let line = raw[kept..].find('\n').map_or(raw.len(), |at| kept + at + 1);
        let lines = &raw[..line];
        if lines.ends_with('\n') {
            self.out.push_str(lines);
        } else {
            self.out.push_str(lines.trim_end_matches('\r'));
            self.end_line();
        }
        self.empty_line = raw[line..].contains('\n');
    }
}
