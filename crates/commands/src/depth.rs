//! Files and macros that run each other: how deep they may, what becomes of those that never end, and
//! the calls that a diagnostic names.

use std::collections::HashMap;

use text::{Diagnostic, FileId, Span};

use crate::{Interpreter, OnError, interpreter::Flow};

/// Files that read each other, and macros that call each other, up to this depth.
const DEEPEST: usize = 100;

/// Of more calls than both together the innermost and the outermost are named.
const INNERMOST: usize = 3;
const OUTERMOST: usize = 2;

const CALLED: &str = "called from here";

/// The texts that are running, and whether they are being left because there are too many.
#[derive(Debug, Default)]
pub(crate) struct Depth {
    /// Each with the number of calls that led to it, outermost first.
    running: Vec<(FileId, usize)>,
    /// The number of calls above the statement that began what does not end: that statement fails,
    /// and everything below it is left.
    unwinds_to: Option<usize>,
    /// Whether the present run came too deep anywhere.
    seen: bool,
}

impl Depth {
    pub(crate) fn is_unwinding(&self) -> bool {
        self.unwinds_to.is_some()
    }
}

impl Interpreter {
    /// Whether one more text may run; if so it counts as running.
    pub(crate) fn goes_deeper(&mut self, file: FileId) -> bool {
        if self.depth.running.len() < DEEPEST {
            self.depth.running.push((file, self.trace.len()));
            return true;
        }
        // Only the first call of what runs without end fails, and not each of a hundred: what follows
        // the inner ones would call again and again.
        let name = self.sources.name(file);
        let first = self.depth.running.iter().find(|(other, _)| self.sources.name(*other) == name);
        let above = first.or(self.depth.running.first()).map_or(0, |(_, calls)| calls.saturating_sub(1));
        let mut error = Diagnostic::error("command/too-deep", "files or macros call each other without end")
            .note(format!("stopped {DEEPEST} calls deep"))
            .help("let a condition end it: `return` leaves a file or macro");
        if let Some(innermost) = self.trace.last() {
            error = error.at(*innermost, "one call too many");
        }
        if let Some(began) = self.trace.get(above).filter(|_| self.trace.len() > above + 1) {
            error = error.label(*began, "it began here");
        }
        self.depth.unwinds_to = Some(above);
        self.depth.seen = true;
        self.report.failed += 1;
        self.complain(vec![error]);
        false
    }

    /// A text has been left; whether because calls came too deep.
    pub(crate) fn comes_back(&mut self) -> bool {
        self.depth.running.pop();
        if self.depth.running.is_empty() {
            self.depth.unwinds_to = None;
        }
        self.depth.is_unwinding()
    }

    /// What follows a statement: where it began calls that came too deep, it is the one that failed.
    pub(crate) fn unwound(&mut self, flow: Flow) -> Flow {
        match self.depth.unwinds_to {
            None => flow,
            Some(above) if self.trace.len() > above => Flow::Abort,
            Some(_) => {
                self.depth.unwinds_to = None;
                if self.on_error == OnError::AbortFile { Flow::Abort } else { Flow::Next }
            }
        }
    }

    /// Where calls came too deep, what was said at every depth is said once.
    pub(crate) fn say_once(&mut self, diagnostics: &mut Vec<Diagnostic>) {
        if !std::mem::take(&mut self.depth.seen) {
            return;
        }
        // Two calls that began apart are two troubles.
        let mut first = HashMap::new();
        let mut kept: Vec<(Diagnostic, usize)> = Vec::new();
        for diagnostic in std::mem::take(diagnostics) {
            let place = diagnostic.primary.as_ref().map(|l| (self.sources.name(l.span.file).to_string(), l.span.start));
            let outermost = diagnostic.secondary.last().map(|l| l.span);
            let key = (diagnostic.code, diagnostic.message.clone(), place, outermost);
            if let Some((_, more)) = first.get(&key).and_then(|at: &usize| kept.get_mut(*at)) {
                *more += 1;
            } else {
                first.insert(key, kept.len());
                kept.push((diagnostic, 0));
            }
        }
        diagnostics.extend(kept.into_iter().map(|(diagnostic, more)| match more {
            0 => diagnostic,
            1 => diagnostic.note("the same is wrong once more in the calls that follow"),
            _ => diagnostic.note(format!("the same is wrong {more} more times in the calls that follow")),
        }));
    }
}

/// Names the calls that led to a diagnostic, innermost first, unless it names them already.
pub(crate) fn add_calls(diagnostic: &mut Diagnostic, trace: &[Span]) {
    if diagnostic.secondary.iter().any(|l| l.text == CALLED) {
        return;
    }
    let named = |call: &Span| {
        let of_own = diagnostic.secondary.iter().chain(&diagnostic.primary).any(|l| l.span == *call);
        !of_own
    };
    let calls: Vec<Span> = trace.iter().rev().copied().filter(named).collect();
    let between = calls.len().saturating_sub(INNERMOST + OUTERMOST);
    // One left out would take as much room as saying so.
    let between = if between > 1 { INNERMOST..INNERMOST + between } else { 0..0 };
    for (at, call) in calls.iter().enumerate().filter(|(at, _)| !between.contains(at)) {
        let text = if at == between.end && !between.is_empty() {
            format!("{CALLED}, {} calls further out", between.len() + 1)
        } else {
            CALLED.to_string()
        };
        diagnostic.secondary.push(text::Label { span: *call, text });
    }
    if !between.is_empty() {
        diagnostic.notes.push(format!("... {} more calls between", between.len()));
    }
}
