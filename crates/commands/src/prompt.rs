//! Prompts: a command of a file that lacks a required argument asks for it, and the next line of the
//! file is the answer, whatever it was meant to be.

use std::ops::Range;

use model::Mark;
use text::{Diagnostic, FileId, Span};

use crate::{Interpreter, blocks::Control, interpreter::Flow, program::Program};

type Errors = Vec<Diagnostic>;

/// Lines that are no answer, because blocks would lose their beginning or end.
const BLOCKS: [&str; 9] = ["if", "elseif", "else", "end", "while", "for", "break", "continue", "return"];

impl Interpreter {
    /// Whether a statement begins on a line that was taken as an answer.
    pub(crate) fn was_an_answer(&self, program: &Program, index: usize) -> bool {
        let start = program.statements[index].statement.span.start;
        self.answered.is_some_and(|(file, end)| file == program.file && start < end)
    }

    /// Asks for what a failed statement lacks and runs it again with the answers. None if it lacks
    /// nothing or cannot ask.
    pub(crate) fn ask(
        &mut self,
        program: &Program,
        index: usize,
        mark: Mark,
        errors: &mut Errors,
    ) -> Option<Result<Flow, Errors>> {
        if !self.asking.contains(&program.file) {
            return None;
        }
        let mut name = lacking(errors)?;
        let span = program.statements[index].statement.span;
        let mut text = program.word(span).to_string();
        let mut pieces = vec![Piece { from: 0..span.end - span.start, to: span.start..span.end }];
        let mut line = program.line_number(span.end);
        let depth = self.block_depth as i64;
        self.echo_at(program, span, depth);
        loop {
            self.database.roll_back(mark);
            self.taken_back();
            line += 1;
            let answer = self.answer(program, line);
            if let Some(journal) = &mut self.journal {
                journal.prompt(&name);
            }
            let Some(answer) = answer else {
                self.no_answer(program, line, errors);
                return Some(Err(std::mem::take(errors)));
            };
            let named = text.len() as u32;
            text.extend([" &\n", &name, " = "]);
            let (answered, place) = (text.len() as u32, place_of_answer(program, line));
            text.push_str(&answer);
            pieces.push(Piece { from: named..answered, to: place.start..place.start });
            pieces.push(Piece { from: answered..text.len() as u32, to: place });
            let title = format!("{} with the answer to its prompt", self.sources.name(program.file));
            let file = self.sources.add(title, text.clone());
            let again = Program::parse(&self.sources, file);
            // The lines of the command are on record already.
            let journal = self.journal.take();
            let said = self.report.diagnostics.len();
            let outcome = if again.statements.len() == 1 {
                self.try_statement(&again, 0, Control::Plain)
            } else {
                Err(std::mem::take(errors))
            };
            self.journal = journal;
            let there = Composed { file, pieces: &pieces, source: program.file };
            self.report.diagnostics.iter_mut().skip(said).for_each(|d| there.map(d));
            self.function_places.values_mut().for_each(|place| *place = there.place(*place));
            match outcome {
                Ok(flow) => {
                    if let Some(journal) = &mut self.journal {
                        journal.answered(program, line);
                    }
                    return Some(Ok(flow));
                }
                Err(mut found) => {
                    if let Some(next) = lacking(&found).filter(|next| *next != name) {
                        if let Some(journal) = &mut self.journal {
                            journal.answered(program, line);
                        }
                        name = next;
                        found.iter_mut().for_each(|d| there.map(d));
                        *errors = found;
                        continue;
                    }
                    note_answer(&mut found, &name, &answer);
                    self.refuse_answer(program, line, &found);
                    found.iter_mut().for_each(|d| there.map(d));
                    return Some(Err(found));
                }
            }
        }
    }

    /// The text of a line as an answer; it is no command any more.
    fn answer(&mut self, program: &Program, line: usize) -> Option<String> {
        let text = program.line(line);
        let first = text.trim_start().split(|c: char| !c.is_ascii_alphanumeric()).next().unwrap_or("");
        if BLOCKS.iter().any(|word| word.eq_ignore_ascii_case(first)) {
            return None;
        }
        // Lines of one file begin where the one before ends.
        let end = program.line_start(line + 1);
        self.answered = Some((program.file, end));
        let text = text.trim();
        let usable = !text.is_empty() && !text.starts_with('!') && !text.ends_with('&');
        usable.then(|| text.to_string())
    }

    fn no_answer(&mut self, program: &Program, line: usize, errors: &mut Errors) {
        let taken = program.line(line).trim().to_string();
        for error in errors.iter_mut() {
            error.notes.push(if taken.is_empty() {
                "the line behind the command, which would be the answer, is empty".into()
            } else {
                format!("the line behind the command is taken as the answer: `{taken}`")
            });
        }
        let found = errors.clone();
        self.refuse_answer(program, line, &found);
    }

    fn refuse_answer(&mut self, program: &Program, line: usize, errors: &Errors) {
        let name = self.sources.name(program.file).to_string();
        if let (Some(journal), Some(error)) = (&mut self.journal, errors.first()) {
            journal.refused_answer(program, line, error, &name);
        }
    }
}

/// A piece of a command that was put together, and where it stands in the file.
struct Piece {
    from: Range<u32>,
    to: Range<u32>,
}

/// A command with the answers to its prompts, which is a text of its own.
struct Composed<'a> {
    file: FileId,
    /// In order, without gaps.
    pieces: &'a [Piece],
    source: FileId,
}

impl Composed<'_> {
    /// Moves the places of a diagnostic to where the command and its answers were read.
    fn map(&self, diagnostic: &mut Diagnostic) {
        for label in diagnostic.primary.iter_mut().chain(&mut diagnostic.secondary) {
            label.span = self.place(label.span);
        }
        for fix in diagnostic.helps.iter_mut().filter_map(|help| help.fix.as_mut()) {
            fix.span = self.place(fix.span);
        }
    }

    fn place(&self, span: Span) -> Span {
        if span.file != self.file {
            return span;
        }
        let (start, end) = (self.offset(span.start, false), self.offset(span.end, true));
        Span { file: self.source, start, end: end.max(start) }
    }

    /// Where an offset lies in the file; an end belongs to the piece before it.
    fn offset(&self, at: u32, is_end: bool) -> u32 {
        let holds = |p: &&Piece| if is_end { at <= p.from.end } else { at < p.from.end };
        let Some(piece) = self.pieces.iter().find(holds).or(self.pieces.last()) else { return at };
        (piece.to.start + (at - piece.from.start)).min(piece.to.end)
    }
}

/// Where the text of an answer stands.
fn place_of_answer(program: &Program, line: usize) -> Range<u32> {
    let text = program.line(line);
    let start = program.line_start(line) + (text.len() - text.trim_start().len()) as u32;
    start..start + text.trim().len() as u32
}

/// The parameter that is asked for, if nothing else is wrong.
fn lacking(errors: &Errors) -> Option<String> {
    let all = errors.iter().all(|e| e.code == "command/missing-argument");
    let first = errors.first().filter(|_| all)?;
    let text = first.adams_text.first()?;
    Some(text.strip_prefix("Enter ")?.strip_suffix(" (required)")?.to_string())
}

fn note_answer(errors: &mut Errors, name: &str, answer: &str) {
    for error in errors {
        error
            .notes
            .push(format!("`{name}` is missing; the line behind the command is taken as the answer: `{answer}`"));
    }
}
