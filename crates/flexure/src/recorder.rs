//! What is kept of a run while it goes on: rows of results, and what elements are concerned about.

use equations::{Concern, System};
use results::Table;
use solver::{Control, Dae, Observer, SystemState};
use text::Diagnostic;

use crate::run::{Progress, RunObserver};

/// Hands outputs to the observer and keeps them; notes what elements are concerned about.
pub(crate) struct Recorder<'a> {
    pub observer: &'a mut dyn RunObserver,
    pub outputs: elements::Outputs,
    pub table: Table,
    pub row: Vec<f64>,
    /// What elements were concerned about, in order of first appearance.
    pub concerns: Vec<Noted>,
    pub stopped: bool,
    pub start: f64,
}

impl Recorder<'_> {
    pub fn record(&mut self, system: &mut System, state: &SystemState) {
        let SystemState { t, q, v, a, lambda } = state;
        self.outputs.evaluate(system, *t, q, v, a, lambda, &mut self.row);
        self.table.push(&self.row);
        self.observer.row(&self.row);
        system.state(*t, q, v, None);
        let now = system.last_state();
        let forces = system.force_list().iter().map(|f| (f.name(), f.concern(now)));
        let constraints = system.constraint_list().iter().map(|c| (c.name(), c.concern(now)));
        for (index, (name, concern)) in forces.chain(constraints).enumerate() {
            if let Some(concern) = concern {
                note(&mut self.concerns, self.observer, index, name, concern, *t);
            }
        }
    }
}

impl Observer for Recorder<'_> {
    fn output(&mut self, dae: &mut dyn Dae, state: &SystemState) -> Control {
        if let Some(system) = dae.as_any().and_then(|any| any.downcast_mut::<System>()) {
            self.record(system, state);
        }
        Control::Continue
    }

    fn progress(&mut self, progress: &solver::Progress) -> Control {
        let shown = if progress.end > self.start {
            Progress::Time { start: self.start, now: progress.t, end: progress.end, step: progress.step }
        } else {
            Progress::Iterations { done: progress.statistics.iterations, correction: progress.step }
        };
        let control = self.observer.progress(&shown);
        self.stopped |= control == Control::Stop;
        control
    }
}

/// What one element was concerned about, at its worst.
pub(crate) struct Noted {
    /// Which force or constraint of the system.
    index: usize,
    name: String,
    concern: Concern,
    /// When it was worst, s.
    time: f64,
}

/// Keeps a concern if it is new or worse than before; a new one is said at once.
fn note(noted: &mut Vec<Noted>, observer: &mut dyn RunObserver, index: usize, name: &str, concern: Concern, time: f64) {
    match noted.iter_mut().find(|n| n.index == index) {
        Some(known) if concern.size > known.concern.size => (known.concern, known.time) = (concern, time),
        Some(_) => {}
        None => {
            let Concern { sentence, size, unit, .. } = concern;
            observer.message(&format!("WARNING: {name}: {sentence} ({size:.1} {unit}), first at t = {time:.6} s"));
            noted.push(Noted { index, name: name.to_string(), concern, time });
        }
    }
}

/// One warning for each kind of concern, with all elements and sizes.
pub(crate) fn concern_warnings(noted: &[Noted]) -> Vec<Diagnostic> {
    let mut kinds: Vec<&'static str> = Vec::new();
    for Noted { concern, .. } in noted {
        if !kinds.contains(&concern.sentence) {
            kinds.push(concern.sentence);
        }
    }
    let warning = |kind: &'static str| {
        let of_kind: Vec<&Noted> = noted.iter().filter(|n| n.concern.sentence == kind).collect();
        let names = if of_kind.len() == 1 { "1 element is".into() } else { format!("{} elements are", of_kind.len()) };
        let text = match kind.strip_prefix("the ") {
            Some(_) => format!("{}: {kind}", of_kind[0].name),
            None => format!("{names} {kind}"),
        };
        of_kind.iter().fold(Diagnostic::warning("run/beyond-validity", text), |warning, noted| {
            let Concern { size, unit, pieces, .. } = noted.concern;
            let instead = pieces.map_or_else(String::new, |n| format!("; {n} in its place would do"));
            warning.note(format!("{}: {size:.1} {unit} at t = {:.4} s{instead}", noted.name, noted.time))
        })
    };
    kinds.into_iter().map(warning).collect()
}
