//! One simulation as users see it: what it is called, how it goes on, what it left.

use std::fmt;

use results::Table;
pub use solver::Control;
use solver::Statistics;
use text::Diagnostic;

/// What is known of a run when it begins.
#[derive(Clone, Debug)]
pub struct RunHeader {
    /// Name of the model, without dot.
    pub model: String,
    /// Short name for files: `1_static`, `2_dynamic`; numbered through the session.
    pub name: String,
    /// For people: `static equilibrium`, `dynamic simulation to 10 s`.
    pub title: String,
    /// Name and unit of every series; the first is time.
    pub columns: Vec<(String, String)>,
}

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Simulated time, where it began and ends, and the present step size; seconds.
    Time { start: f64, now: f64, end: f64, step: f64 },
    /// Iterations of a static analysis and the size of the last correction.
    Iterations { done: usize, correction: f64 },
}

impl Progress {
    /// Done part, 0 to 1.
    pub fn fraction(&self) -> f64 {
        match *self {
            Progress::Time { start, now, end, .. } if end > start => ((now - start) / (end - start)).clamp(0.0, 1.0),
            Progress::Time { .. } => 1.0,
            // How many there will be is not known; the bar creeps towards its end.
            Progress::Iterations { done, .. } => done as f64 / (done as f64 + 50.0),
        }
    }
}

impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Progress::Time { now, end, step, .. } => write!(f, "t = {now:.4} of {end:.4} s, step {step:.2e} s"),
            Progress::Iterations { done, correction } => write!(f, "iteration {done}, correction {correction:.2e}"),
        }
    }
}

/// Watches runs while they go on. All methods have a default that does nothing.
pub trait RunObserver: Send {
    fn begin(&mut self, _header: &RunHeader) {}
    /// One row of results, in the order of the header's columns, model units.
    fn row(&mut self, _row: &[f64]) {}
    /// Asked after every step; `Stop` ends the run, which keeps what it has.
    fn progress(&mut self, _progress: &Progress) -> Control {
        Control::Continue
    }
    /// Something the user should read now: redundant constraints, a warning of an element.
    fn message(&mut self, _text: &str) {}
    /// A line that a command was asked for: information on objects, a report.
    fn listing(&mut self, line: &str) {
        self.message(line);
    }
    fn end(&mut self, _run: &Run) {}
}

/// An observer that watches nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl RunObserver for Silent {}

/// A finished (or interrupted) run.
#[derive(Clone, Debug)]
pub struct Run {
    pub header: RunHeader,
    /// Results in model units.
    pub table: Table,
    pub statistics: Statistics,
    /// Messages in order, as the solver's message file would hold them.
    pub messages: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
    pub interrupted: bool,
    /// The analysis gave up: why is told, with these diagnostics, to whoever asked for the run.
    pub failed: bool,
}

impl Run {
    /// Counts of the solver's work by name.
    pub fn counts(&self) -> [(&'static str, usize); 6] {
        let s = &self.statistics;
        [
            ("steps", s.steps),
            ("rejected", s.rejected),
            ("newton_iterations", s.iterations),
            ("residuals", s.residuals),
            ("jacobians", s.jacobians),
            ("factorisations", s.factorisations),
        ]
    }

    /// The work in a sentence.
    pub fn work(&self) -> String {
        let s = &self.statistics;
        format!(
            "{} outputs, {} steps, {} Newton iterations, {} factorisations",
            self.table.rows(),
            s.steps,
            s.iterations,
            s.factorisations
        )
    }
}
