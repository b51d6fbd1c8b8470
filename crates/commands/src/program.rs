//! A text that was parsed: its statements and the words their spans cover.

use std::sync::Arc;

use syntax::command::{Argument, Parser, Statement, StatementKind};
use text::{Diagnostic, FileId, Source, Sources, Span};

/// One statement with what the parser said about it.
#[derive(Clone, Debug)]
pub struct Parsed {
    pub statement: Statement,
    pub diagnostics: Vec<Diagnostic>,
}

/// Statements of a file, command line or macro body that are executed together, any number of times.
#[derive(Debug)]
pub struct Program {
    pub file: FileId,
    source: Arc<Source>,
    pub statements: Vec<Parsed>,
}

impl Program {
    /// A program of the statements of a text, none of them read yet.
    pub fn new(sources: &Sources, file: FileId) -> Program {
        Program { file, source: sources.share(file), statements: Vec::new() }
    }

    /// A program of all statements of a text.
    pub fn parse(sources: &Sources, file: FileId) -> Program {
        let mut program = Program::new(sources, file);
        let source = program.source.clone();
        let mut parser = Parser::new(file, source.text());
        while program.read(&mut parser) {}
        program
    }

    /// Reads the next statement; false at the end of the text.
    pub fn read(&mut self, parser: &mut Parser) -> bool {
        let Some((statement, diagnostics)) = parser.next_statement() else { return false };
        self.statements.push(Parsed { statement, diagnostics });
        true
    }

    /// The whole text that the statements are taken from.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// A physical line, counted from 0, without its end.
    pub fn line(&self, number: usize) -> &str {
        let line_starts = self.source.line_starts();
        let Some(&start) = line_starts.get(number) else { return "" };
        let end = line_starts.get(number + 1).map_or(self.text().len(), |e| *e as usize);
        self.text().get(start as usize..end).unwrap_or("").trim_end_matches(['\n', '\r'])
    }

    /// The physical line of an offset, from 0.
    pub fn line_number(&self, offset: u32) -> usize {
        self.source.line_number(offset)
    }

    /// Where a physical line begins, counted from 0; the end of the text behind the last.
    pub fn line_start(&self, number: usize) -> u32 {
        self.source.line_starts().get(number).copied().unwrap_or(self.text().len() as u32)
    }

    pub fn line_count(&self) -> usize {
        let lines = self.source.line_starts().len();
        if self.text().ends_with('\n') || self.text().is_empty() { lines - 1 } else { lines }
    }

    /// The text a span covers; empty for a span of another file.
    pub fn word(&self, span: Span) -> &str {
        if span.file == self.file { self.text().get(span.range()).unwrap_or("") } else { "" }
    }

    /// The keywords of a command and its arguments; `None` for assignments and broken lines.
    pub fn command(&self, index: usize) -> Option<(&[Span], &[Argument])> {
        match &self.statements.get(index)?.statement.kind {
            StatementKind::Command { keywords, arguments } => Some((keywords, arguments)),
            _ => None,
        }
    }
}
