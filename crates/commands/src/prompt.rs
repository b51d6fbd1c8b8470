//! Prompts: a command of a file that lacks a required argument asks for it, and the next line of the
//! file is the answer, whatever it was meant to be.

use model::Mark;
use text::Diagnostic;

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
            text.extend([" &\n", &name, " = ", &answer]);
            let title = format!("{} with the answer to its prompt", self.sources.name(program.file));
            let file = self.sources.add(title, text.clone());
            let again = Program::parse(&self.sources, file);
            // The lines of the command are on record already.
            let journal = self.journal.take();
            let outcome = if again.statements.len() == 1 {
                self.try_statement(&again, 0, Control::Plain)
            } else {
                Err(std::mem::take(errors))
            };
            self.journal = journal;
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
                        *errors = found;
                        continue;
                    }
                    note_answer(&mut found, &name, &answer);
                    self.refuse_answer(program, line, &found);
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
