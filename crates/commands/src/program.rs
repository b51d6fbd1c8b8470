//! A text that was parsed: its statements and the words their spans cover.

use std::sync::Arc;

use syntax::command::{Argument, Parser, Statement, StatementKind};
use text::{Diagnostic, FileId, Sources, Span};

/// One statement with what the parser said about it.
#[derive(Clone, Debug)]
pub struct Parsed {
    pub statement: Statement,
    pub diagnostics: Vec<Diagnostic>,
}

/// A whole file, command line or macro body, ready to be executed any number of times.
#[derive(Debug)]
pub struct Program {
    pub file: FileId,
    pub text: Arc<str>,
    pub statements: Vec<Parsed>,
    /// Offsets at which physical lines begin.
    line_starts: Vec<u32>,
}

impl Program {
    pub fn parse(sources: &Sources, file: FileId) -> Program {
        let text: Arc<str> = sources.text(file).into();
        let mut statements = Vec::new();
        let mut parser = Parser::new(file, &text);
        while let Some((statement, diagnostics)) = parser.next_statement() {
            statements.push(Parsed { statement, diagnostics });
        }
        let breaks = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i as u32 + 1);
        let line_starts = std::iter::once(0).chain(breaks).collect();
        Program { file, text, statements, line_starts }
    }

    /// A physical line, counted from 0, without its end.
    pub fn line(&self, number: usize) -> &str {
        let Some(&start) = self.line_starts.get(number) else { return "" };
        let end = self.line_starts.get(number + 1).map_or(self.text.len(), |e| *e as usize);
        self.text.get(start as usize..end).unwrap_or("").trim_end_matches(['\n', '\r'])
    }

    /// The physical line of an offset, from 0.
    pub fn line_number(&self, offset: u32) -> usize {
        self.line_starts.partition_point(|start| *start <= offset).saturating_sub(1)
    }

    pub fn line_count(&self) -> usize {
        if self.text.ends_with('\n') || self.text.is_empty() {
            self.line_starts.len() - 1
        } else {
            self.line_starts.len()
        }
    }

    /// The text a span covers; empty for a span of another file.
    pub fn word(&self, span: Span) -> &str {
        if span.file == self.file { self.text.get(span.range()).unwrap_or("") } else { "" }
    }

    /// The keywords of a command and its arguments; `None` for assignments and broken lines.
    pub fn command(&self, index: usize) -> Option<(&[Span], &[Argument])> {
        match &self.statements.get(index)?.statement.kind {
            StatementKind::Command { keywords, arguments } => Some((keywords, arguments)),
            _ => None,
        }
    }
}
