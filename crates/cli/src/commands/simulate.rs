//! `flexure simulate`: one simulation of a model, results to a file.

use std::sync::PoisonError;

use flexure::{Analysis, Outputs, SimulationOptions};

use crate::arguments::Simulate;
use crate::commands::{complain, open, print_found, session, set_beams, set_recording};
use crate::output::{Target, extension};
use crate::progress::Watcher;
use crate::{Outcome, interrupt};

pub(super) fn execute(simulate: &Simulate) -> Outcome {
    let known = ["", "csv", "parquet"];
    if !known.contains(&extension(&simulate.out).as_str()) && !simulate.out.is_dir() {
        complain(format_args!("results are written as .csv or .parquet, not as {}", simulate.out.display()));
        return Outcome::Usage;
    }
    interrupt::install();
    let mut session = session();
    set_beams(&mut session, &simulate.beams);
    session.simulate_nothing(true);
    set_recording(&mut session, simulate.record);
    if !open(&mut session, &simulate.model, &simulate.edits) {
        complain("the model has errors; nothing was simulated");
        return Outcome::Findings;
    }
    session.simulate_nothing(false);
    let (watcher, log) = Watcher::new(Target::of(&simulate.out));
    session.set_observer(Box::new(watcher));
    let outputs = match (simulate.steps, simulate.dtout) {
        (Some(steps), _) => Outputs::Steps(steps),
        (None, Some(interval)) => Outputs::Interval(interval),
        (None, None) => Outputs::Steps(100),
    };
    let mut runs = Vec::new();
    if simulate.statics {
        runs.push(Analysis::Static);
    }
    if let Some(end) = simulate.end {
        runs.push(if simulate.kinematic {
            Analysis::Kinematic { end, outputs }
        } else {
            Analysis::Dynamic { end, outputs }
        });
    }
    let mut outcome = Outcome::Fine;
    for analysis in runs {
        let options = SimulationOptions {
            analysis,
            integrator: simulate.integrator.clone(),
            error: simulate.error,
            largest_step: simulate.hmax,
        };
        match session.simulate(&options) {
            Ok(run) => {
                eprintln!("{}: {}", run.header.title, run.work());
                if run.interrupted {
                    outcome = Outcome::Interrupted;
                    break;
                }
            }
            Err(diagnostics) => {
                print_found(&session, &diagnostics);
                outcome = Outcome::Findings;
                break;
            }
        }
    }
    let log = log.lock().unwrap_or_else(PoisonError::into_inner);
    log.troubles.iter().for_each(complain);
    let mut written = log.written.clone();
    written.dedup();
    for path in written {
        println!("{}", path.display());
    }
    if log.troubles.is_empty() { outcome } else { Outcome::Findings }
}
