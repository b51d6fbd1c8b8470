//! The session log in the layout of `aview.log`.
//!
//! What was typed stands in it as typed, so that the log itself is a command file that builds the
//! same model; everything else begins with `! `: echoes of each line, with the depth of blocks
//! (negative while lines are skipped), messages, and the box round a command that was refused.

use text::{Diagnostic, Severity};

use crate::{Interpreter, program::Program};

const RULE: &str = "! ERROR:  ---------------------------------------------------------------------";

/// The code of what says which objects a pattern means.
pub(crate) const PATTERN: &str = "name/pattern";

/// Errors that Adams reports while it executes a command, not while it reads it: without a box.
const WHILE_EXECUTING: [&str; 1] = ["constraint/point-mass"];

/// The lines of a session.
#[derive(Clone, Debug, Default)]
pub struct Journal {
    lines: Vec<String>,
    /// First physical line of the running program that is not echoed yet, from 0.
    next_line: usize,
    /// First physical line of the running program that is not kept as typed yet, from 0.
    kept_to: usize,
    /// Whether the running program was typed, and whether the next one is.
    typed: bool,
    typed_next: bool,
    /// Messages of the report that are already written.
    reported: usize,
    /// Messages of the report of which those about patterns are already written.
    patterns_said: usize,
}

/// How far the program that runs another has come.
#[derive(Clone, Copy)]
pub(crate) struct Outer {
    next_line: usize,
    kept_to: usize,
    typed: bool,
}

impl Journal {
    /// Everything written so far.
    pub fn text(&self) -> String {
        let mut text = self.lines.join("\n");
        text.push('\n');
        text
    }

    /// Lines since a number of lines: for writing to a file as the session goes on.
    pub fn lines_from(&self, first: usize) -> &[String] {
        self.lines.get(first..).unwrap_or(&[])
    }

    pub fn raw(&mut self, text: &str) {
        self.lines.extend(text.lines().map(str::to_string));
    }

    fn message(&mut self, line: &str) {
        self.lines.push(format!("! {line}"));
    }

    /// The next program is text that was typed.
    pub(crate) fn expect_typed(&mut self) {
        self.typed_next = true;
    }

    pub(crate) fn begin_program(&mut self) -> Outer {
        let outer = Outer { next_line: self.next_line, kept_to: self.kept_to, typed: self.typed };
        (self.next_line, self.kept_to, self.typed) = (0, 0, std::mem::take(&mut self.typed_next));
        outer
    }

    pub(crate) fn end_program(&mut self, outer: Outer) {
        (self.next_line, self.kept_to, self.typed) = (outer.next_line, outer.kept_to, outer.typed);
    }

    /// Where what is typed next will stand.
    pub(crate) fn mark(&self) -> usize {
        self.lines.len()
    }

    /// Puts what was typed, up to the statement before `next`, in front of its echoes. What was
    /// refused is not kept, so that the journal can be read again.
    pub(crate) fn keep_typed(&mut self, program: &Program, mark: usize, next: usize, refused: bool) {
        let Some(last) = next.checked_sub(1).and_then(|i| program.statements.get(i)) else { return };
        let end = program.line_number(last.statement.span.end) + 1;
        if self.typed && !refused {
            let typed = (self.kept_to..end).map(|line| program.line(line).to_string());
            let at = mark.min(self.lines.len());
            self.lines.splice(at..at, typed);
        }
        self.kept_to = end;
    }

    /// Asks for a parameter.
    pub(crate) fn prompt(&mut self, name: &str) {
        self.message(&format!("Enter {name} (required)"));
    }

    /// A line that was taken as an answer.
    pub(crate) fn answered(&mut self, program: &Program, line: usize) {
        self.message(&format!("-> {}", program.line(line)));
        self.next_line = line + 1;
    }

    /// The box round an answer that does not fit; its column is 0.
    pub(crate) fn refused_answer(&mut self, program: &Program, line: usize, error: &Diagnostic, name: &str) {
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        self.lines.push(RULE.into());
        self.message(&format!("ERROR:  Error detected on line number {}, character 0 of {name}.", line + 1));
        for text in texts(error).iter().filter(|t| !t.starts_with("Enter ")) {
            self.message(&format!("ERROR:  {text}"));
        }
        self.message("ERROR:  The command was not executed.");
        self.message(&format!("ERROR:  -> {}", program.line(line)));
        self.lines.push(RULE.into());
        self.next_line = line + 1;
    }

    /// Echoes lines up to `to`, of which those from `first_of_statement` on are one statement.
    fn echo(&mut self, program: &Program, first_of_statement: usize, to: usize, depth: i64) {
        while self.next_line < to {
            let line = program.line(self.next_line);
            let prefix = prefix(depth, self.next_line > first_of_statement && self.next_line < to);
            self.lines.push(format!("! {prefix} {line}"));
            self.next_line += 1;
        }
    }
}

fn prefix(depth: i64, continued: bool) -> String {
    let mark = if continued { "&>" } else { ">>" };
    match depth {
        0 => mark.to_string(),
        d if d > 0 => format!("+{d}{mark}"),
        d => format!("{d}{mark}"),
    }
}

impl Interpreter {
    /// Echoes a statement that is about to run something that echoes itself.
    pub(crate) fn echo_now(&mut self, program: &Program, span: text::Span) {
        self.echo_at(program, span, self.block_depth as i64);
    }

    /// Echoes a statement at a depth of blocks; a negative one means that it was not executed.
    pub(crate) fn echo_at(&mut self, program: &Program, span: text::Span, depth: i64) {
        if let Some(journal) = &mut self.journal {
            let first = program.line_number(span.start);
            journal.echo(program, first, program.line_number(span.end) + 1, depth);
        }
    }

    /// Echoes a statement that has run, or the box of one that was refused, and new messages.
    pub(crate) fn echo_pending(&mut self, program: &Program, index: usize, errors: Option<&Vec<Diagnostic>>) {
        let depth = self.block_depth as i64;
        let span = program.statements[index].statement.span;
        let Some(journal) = &mut self.journal else { return };
        journal.patterns(&self.report.diagnostics);
        let (first, last) = (program.line_number(span.start), program.line_number(span.end) + 1);
        let refused = errors.and_then(|e| e.iter().find(|d| d.is_error()));
        let place = refused.and_then(|d| d.primary.as_ref()).filter(|l| l.span.file == program.file);
        let place = place.filter(|_| refused.is_some_and(|d| !WHILE_EXECUTING.contains(&d.code)));
        match (refused, place) {
            (Some(error), Some(place)) if journal.next_line < last => {
                let faulty = program.line_number(place.span.end).clamp(first, last - 1);
                journal.echo(program, first, faulty, depth);
                let opening = error.code == "command/unknown-keyword" && place.span.start == span.start;
                let column = column_of(program, place.span.end) + extra_column(program, error, place.span, opening);
                journal.boxed(program, error, (first, faulty, last), column, self.sources.name(program.file), depth);
            }
            // Boxed with the answer to its prompt already.
            (Some(_), _) if journal.next_line > last => {}
            (Some(error), _) => {
                journal.echo(program, first, last, depth);
                journal.messages(error);
            }
            (None, _) => journal.echo(program, first, last, depth),
        }
        journal.warnings(&self.report.diagnostics);
    }

    /// The next pass of a loop echoes from this statement on, as `echo_all_loops` asks.
    pub(crate) fn echo_again(&mut self, program: &Program, index: usize) {
        if let (Some(journal), Some(parsed)) = (&mut self.journal, program.statements.get(index)) {
            journal.next_line = program.line_number(parsed.statement.span.start);
        }
    }

    /// Echoes statements that are read but not executed.
    pub(crate) fn echo_skipped(&mut self, program: &Program, from: usize, to: usize) {
        let depth = -(self.block_depth.max(1) as i64);
        let Some(journal) = &mut self.journal else { return };
        for parsed in program.statements.get(from..to).unwrap_or(&[]) {
            let span = parsed.statement.span;
            journal.echo(program, program.line_number(span.start), program.line_number(span.end) + 1, depth);
        }
    }

    /// Echoes comments and blank lines behind the last statement.
    pub(crate) fn echo_rest(&mut self, program: &Program, flow: crate::interpreter::Flow) {
        if flow == crate::interpreter::Flow::Abort {
            return;
        }
        let depth = self.block_depth as i64;
        if let Some(journal) = &mut self.journal {
            let last = program.line_count();
            journal.echo(program, last, last, depth);
            journal.warnings(&self.report.diagnostics);
        }
    }
}

impl Journal {
    fn boxed(
        &mut self,
        program: &Program,
        error: &Diagnostic,
        (first, faulty, last): (usize, usize, usize),
        column: usize,
        name: &str,
        depth: i64,
    ) {
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        self.lines.push(RULE.into());
        self.lines
            .push(format!("! ERROR:  Error detected on line number {}, character {column} of {name}.", faulty + 1));
        for line in texts(error) {
            self.lines.push(format!("! ERROR:  {line}"));
        }
        self.lines.push("! ERROR:  The command was not executed.".into());
        for line in faulty..last {
            let prefix = prefix(depth, line > first);
            self.lines.push(format!("! ERROR:  {prefix} {}", program.line(line)));
        }
        self.lines.push(RULE.into());
        self.next_line = last;
    }

    /// Message lines of a trouble found while a command ran: the first is marked.
    pub(crate) fn messages(&mut self, diagnostic: &Diagnostic) {
        let word = match diagnostic.severity {
            Severity::Error => "ERROR:  ",
            Severity::Warning => "WARNING:  ",
            Severity::Note => "",
        };
        // This one message has its mark on both lines.
        let all = diagnostic.code == "command/unclosed-block";
        for (i, line) in texts(diagnostic).iter().enumerate() {
            self.message(&format!("{}{line}", if i == 0 || all { word } else { "" }));
        }
    }

    /// Warnings of the report that are not in the journal yet.
    fn warnings(&mut self, diagnostics: &[Diagnostic]) {
        if self.reported > diagnostics.len() {
            self.reported = 0;
        }
        let said = std::mem::take(&mut self.patterns_said);
        for (at, diagnostic) in diagnostics.iter().enumerate().skip(self.reported) {
            let said_before = at < said && diagnostic.code == PATTERN;
            if !diagnostic.is_error() && !said_before {
                self.messages(diagnostic);
            }
        }
        self.reported = diagnostics.len();
    }

    /// What patterns of a command mean is said before the command is echoed.
    fn patterns(&mut self, diagnostics: &[Diagnostic]) {
        if self.reported > diagnostics.len() {
            self.reported = 0;
        }
        for diagnostic in diagnostics[self.reported..].iter().filter(|d| d.code == PATTERN) {
            self.messages(diagnostic);
        }
        self.patterns_said = diagnostics.len();
    }

    /// Lines of a report shown in the information window.
    pub(crate) fn information(&mut self, lines: &[String]) {
        for line in lines {
            self.message(line);
        }
    }
}

/// What Adams prints, or our own words where that is unknown.
fn texts(diagnostic: &Diagnostic) -> Vec<String> {
    if diagnostic.adams_text.is_empty() { vec![diagnostic.message.clone()] } else { diagnostic.adams_text.clone() }
}

fn column_of(program: &Program, offset: u32) -> usize {
    let before = program.text().get(..offset as usize).unwrap_or("");
    before.rsplit('\n').next().unwrap_or("").chars().count()
}

/// Adams counts one column more behind a word, and two behind the name of an object that should
/// exist and behind a first keyword; never more than the line has.
fn extra_column(program: &Program, error: &Diagnostic, place: text::Span, first: bool) -> usize {
    let existing = error.code.starts_with("name/") && error.code != "name/taken";
    let wanted = if existing || first { 2 } else { 1 };
    let line = program.line(program.line_number(place.end)).chars().count();
    wanted.min(line.saturating_sub(column_of(program, place.end)))
}
