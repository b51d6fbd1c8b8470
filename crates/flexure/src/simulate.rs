//! One run from model to results: what is asked for, the analysis, what comes of it.

use elements::{Lowered, Options};
use equations::System;
use model::{Database, ObjectId};
use results::Table;
use solver::{
    Control, Dae, Failure, IntegratorOptions, StaticOptions, Statistics, SystemState, equilibrium, initial, integrate,
};
use text::Diagnostic;

use crate::recorder::{Recorder, concern_warnings};
use crate::run::{Progress, Run, RunHeader, RunObserver};
use crate::settings::{Analysis, Outputs, SimulationOptions, integrator_options, static_options};
use crate::start::{Prepared, failed, prepare};

/// What a run is made of.
pub(crate) struct Simulation<'a> {
    pub database: &'a Database,
    pub model: ObjectId,
    /// Number of the run in the session.
    pub number: usize,
    pub lowering: Options,
    pub options: &'a SimulationOptions,
    /// Settings that solver commands gave for this run.
    pub settings: &'a [(String, String, String)],
    /// Where the last analysis left the model.
    pub from: Option<SystemState>,
}

/// Runs a simulation; returns the run, where it left the model, and what was odd at its start.
pub(crate) fn run(
    simulation: &Simulation<'_>,
    observer: &mut dyn RunObserver,
) -> Result<(Run, SystemState, Vec<Diagnostic>), Vec<Diagnostic>> {
    let Simulation { database, model, .. } = *simulation;
    let prepared = prepare(database, model, simulation.from.clone(), simulation.lowering)?;
    let Prepared { lowered, mut state, mut messages, warnings, freedom } = prepared;
    let analysis = settle(simulation.options.analysis, freedom, &mut messages)?;
    // Whatever is wrong with the settings is said before results of an earlier run are touched.
    let plan = Plan::new(simulation, analysis, state.t, &mut messages)?;
    let name = database.object(model).name.clone();
    let (short, title) = titles(analysis);
    let columns = lowered.outputs.columns();
    let header = RunHeader { model: name, name: format!("{}_{short}", simulation.number), title, columns };
    observer.begin(&header);
    messages.iter().for_each(|m| observer.message(m));
    let Lowered { mut system, outputs, diagnostics, .. } = lowered;
    let width = header.columns.len();
    let mut recorder = Recorder {
        observer,
        outputs,
        table: Table::with_columns(header.columns.clone()),
        row: vec![0.0; width],
        concerns: Vec::new(),
        stopped: false,
        start: state.t,
    };
    let outcome = analyse(&plan, &mut system, &mut state, &mut recorder, &mut messages);
    let Recorder { table, concerns, stopped, observer, .. } = recorder;
    let mut run = Run {
        header,
        table,
        statistics: Statistics::default(),
        messages,
        diagnostics,
        interrupted: stopped,
        failed: outcome.is_err(),
    };
    run.diagnostics.extend(concern_warnings(&concerns));
    match outcome {
        Ok(statistics) => {
            run.statistics = statistics;
            observer.end(&run);
            Ok((run, state, warnings))
        }
        Err(mut errors) => {
            observer.end(&run);
            errors.extend(run.diagnostics);
            Err(errors)
        }
    }
}

/// Chooses between kinematic and dynamic, and says what Adams says of a determinate model.
fn settle(analysis: Analysis, freedom: usize, messages: &mut Vec<String>) -> Result<Analysis, Vec<Diagnostic>> {
    Ok(match analysis {
        Analysis::Kinematic { .. } if freedom > 0 => {
            let text = format!("a kinematic analysis needs a model without degrees of freedom; this one has {freedom}");
            let help = "run a dynamic analysis, or drive what moves freely by motions";
            return Err(vec![Diagnostic::error("run/degrees-of-freedom", text).help(help)]);
        }
        Analysis::Auto { end, outputs } if freedom == 0 => Analysis::Kinematic { end, outputs },
        Analysis::Auto { end, outputs } => Analysis::Dynamic { end, outputs },
        Analysis::Dynamic { .. } if freedom == 0 => {
            messages.push(
                "The model has no degree of freedom; a kinematic analysis would be more efficient. \
                 As requested, the simulation continues with a dynamic analysis."
                    .to_string(),
            );
            analysis
        }
        other => other,
    })
}

fn titles(analysis: Analysis) -> (&'static str, String) {
    match analysis {
        Analysis::Static => ("static", "static equilibrium".into()),
        Analysis::Assemble => ("assemble", "initial conditions".into()),
        Analysis::Dynamic { end, .. } | Analysis::Auto { end, .. } => {
            ("dynamic", format!("dynamic simulation to {end} s"))
        }
        Analysis::Kinematic { end, .. } => ("kinematic", format!("kinematic simulation to {end} s")),
        Analysis::QuasiStatic { end, .. } => ("quasi_static", format!("static solutions to {end} s")),
    }
}

/// An analysis with everything it needs, checked.
struct Plan {
    analysis: Analysis,
    /// Output times; empty for analyses at one time.
    times: Vec<f64>,
    integrator: IntegratorOptions,
    statics: StaticOptions,
}

impl Plan {
    fn new(
        simulation: &Simulation<'_>,
        analysis: Analysis,
        now: f64,
        messages: &mut Vec<String>,
    ) -> Result<Plan, Vec<Diagnostic>> {
        let Simulation { database, model, options, settings, .. } = simulation;
        let times = match analysis {
            Analysis::Static | Analysis::Assemble => Vec::new(),
            Analysis::Dynamic { end, outputs }
            | Analysis::Kinematic { end, outputs }
            | Analysis::QuasiStatic { end, outputs }
            | Analysis::Auto { end, outputs } => times(outputs, now, end)?,
        };
        let (integrator, notes) = integrator_options(database, *model, options, settings)?;
        if matches!(analysis, Analysis::Dynamic { .. }) {
            messages.extend(notes);
        }
        Ok(Plan { analysis, times, integrator, statics: static_options(database, *model, settings) })
    }
}

fn analyse(
    plan: &Plan,
    system: &mut System,
    state: &mut SystemState,
    recorder: &mut Recorder<'_>,
    messages: &mut Vec<String>,
) -> Result<Statistics, Vec<Diagnostic>> {
    let report = |failure: Failure| vec![failed(&failure)];
    match plan.analysis {
        Analysis::Assemble => {
            initial::accelerations(system, state).map_err(report)?;
            recorder.record(system, state);
            Ok(Statistics::default())
        }
        Analysis::Static => balance(system, state, &plan.statics, recorder, messages).map_err(report),
        Analysis::QuasiStatic { .. } => {
            let mut total = Statistics::default();
            for &t in &plan.times {
                state.t = t;
                initial::displacements(system, state, &[]).map_err(report)?;
                let work = balance(system, state, &plan.statics, recorder, messages).map_err(report)?;
                total.iterations += work.iterations;
                total.factorisations += work.factorisations;
                if recorder.stopped {
                    break;
                }
            }
            Ok(total)
        }
        Analysis::Kinematic { end, .. } => move_along(system, state, &plan.times, end, recorder),
        Analysis::Dynamic { end, .. } | Analysis::Auto { end, .. } => {
            integrate(system, state, end, &plan.times, &plan.integrator, recorder).map_err(report)
        }
    }
}

/// Output times; an end before the present time is refused.
fn times(outputs: Outputs, start: f64, end: f64) -> Result<Vec<f64>, Vec<Diagnostic>> {
    let sound = match outputs {
        Outputs::Steps(steps) => steps > 0 && steps <= 100_000_000,
        Outputs::Interval(interval) => interval > 0.0 && (end - start) / interval <= 1e8,
    };
    if !(end > start && end.is_finite() && sound) {
        let text = format!("a run from {start} s to {end} s with these outputs is not possible");
        let help = "the end time must lie after the present time; outputs need a positive step";
        return Err(vec![Diagnostic::error("run/no-time", text).help(help)]);
    }
    Ok(outputs.times(start, end))
}

/// Static equilibrium at the present time.
fn balance(
    system: &mut System,
    state: &mut SystemState,
    options: &StaticOptions,
    recorder: &mut Recorder<'_>,
    messages: &mut Vec<String>,
) -> Result<Statistics, Failure> {
    let moving = state.v.clone();
    system.set_statics(true);
    let found = equilibrium(system, state, options, recorder);
    if let Ok(report) = &found {
        recorder.record(system, state);
        let text = [
            format!("Static Solution converged in {} iterations", report.iterations),
            format!("Residual imbalance is less than {:.5E}", report.imbalance),
        ];
        text.iter().for_each(|line| recorder.observer.message(line));
        messages.extend(text);
    }
    system.set_statics(false);
    // A dynamic analysis after this one starts with the velocities of the model.
    state.v = moving;
    let report = found?;
    initial::velocities(system, state, &[])?;
    Ok(report.statistics)
}

/// Kinematics: positions, velocities, accelerations and reactions at each output time.
fn move_along(
    system: &mut System,
    state: &mut SystemState,
    times: &[f64],
    end: f64,
    recorder: &mut Recorder<'_>,
) -> Result<Statistics, Vec<Diagnostic>> {
    let mut work = Statistics::default();
    for (index, &t) in times.iter().enumerate() {
        let step = t - state.t;
        if index > 0 {
            // The motion so far is the best guess of where the next position lies.
            let guess: Vec<f64> = state.v.iter().zip(&state.a).map(|(v, a)| step * (v + 0.5 * step * a)).collect();
            let mut q = state.q.clone();
            system.retract(&state.q, &guess, &mut q);
            state.q = q;
        }
        state.t = t;
        let report = |f: Failure| vec![failed(&f)];
        let assembly = initial::displacements(system, state, &[]).map_err(report)?;
        initial::velocities(system, state, &[]).map_err(report)?;
        initial::accelerations(system, state).map_err(report)?;
        work.steps += usize::from(index > 0);
        work.iterations += assembly.iterations;
        recorder.record(system, state);
        let progress = Progress::Time { start: recorder.start, now: t, end, step };
        if recorder.observer.progress(&progress) == Control::Stop {
            recorder.stopped = true;
            break;
        }
    }
    Ok(work)
}
