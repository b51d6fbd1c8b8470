//! One run from model to results: lowering, redundant constraints, initial conditions, analysis.

use elements::{Lowered, Options};
use equations::{Concern, Side, System, relative};
use model::{Database, ObjectId};
use results::Table;
use schema::UnitSystem;
use solver::redundancy::{self, SparseRows};
use solver::{
    Control, Dae, Failure, IntegratorOptions, Observer, StaticOptions, Statistics, SystemState, equilibrium, initial,
    integrate,
};
use text::Diagnostic;

use crate::run::{Progress, Run, RunHeader, RunObserver};
use crate::settings::{Analysis, Outputs, SimulationOptions, integrator_options, static_options};

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

/// A model as equations, its redundant equations switched off, at a consistent state.
pub(crate) struct Prepared {
    pub lowered: Lowered,
    pub state: SystemState,
    pub messages: Vec<String>,
    /// Those messages that Adams writes into its log.
    pub warnings: Vec<Diagnostic>,
    /// Degrees of freedom.
    pub freedom: usize,
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
    let mut run = Run { header, table, statistics: Statistics::default(), messages, diagnostics, interrupted: stopped };
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

/// Lowers a model, switches redundant equations off and finds a consistent state.
pub(crate) fn prepare(
    database: &Database,
    model: ObjectId,
    from: Option<SystemState>,
    lowering: Options,
) -> Result<Prepared, Vec<Diagnostic>> {
    let mut lowered = elements::lower(database, model, lowering)?;
    let system = &mut lowered.system;
    system.set_length_unit(database.units().length.si);
    let (q, v) = system.initial_state();
    let mut state = from.filter(|s| s.q.len() == q.len() && s.v.len() == v.len()).unwrap_or_else(|| SystemState {
        t: 0.0,
        q,
        v,
        ..SystemState::default()
    });
    let mut warnings = apart(system, &state, database.units());
    warnings.extend(odd_inertias(database, model));
    let mut messages: Vec<String> = warnings.iter().map(|w| format!("WARNING: {}", w.message)).collect();
    let redundant = switch_off_redundant(system, &state)?;
    if !redundant.is_empty() {
        messages.push("Degree-of-freedom analysis identified redundant constraints in the model:".to_string());
        messages.extend(redundant.iter().map(|r| format!(" -  deactivating constraint equation  {r}")));
    }
    assemble(system, &mut state)?;
    contradictions(system, &state)?;
    let freedom = system.velocities().saturating_sub(system.constraints());
    Ok(Prepared { lowered, state, messages, warnings, freedom })
}

/// Names of the equations that were switched off, `Zi.Xj in .model.JOINT_2`.
fn switch_off_redundant(system: &mut System, state: &SystemState) -> Result<Vec<String>, Vec<Diagnostic>> {
    let rows = system.constraint_rows(state.t, &state.q).map_err(|e| vec![evaluation(&e)])?;
    let sorted = |entries: &[(usize, f64)]| {
        let mut entries = entries.to_vec();
        entries.sort_by_key(|e| e.0);
        entries
    };
    let sparse = SparseRows { columns: system.velocities(), rows: rows.iter().map(|r| sorted(&r.entries)).collect() };
    let mut named = Vec::new();
    for found in redundancy::find(&sparse, &[], redundancy::TOLERANCE) {
        let row = &rows[found.row];
        let constraint = &system.constraint_list()[row.constraint];
        let (short, _) = constraint.equation_name(row.equation);
        named.push(format!("{short} in {}", constraint.name()));
        system.set_active(row.constraint, row.equation, false);
    }
    Ok(named)
}

/// Consistent positions and velocities.
fn assemble(system: &mut System, state: &mut SystemState) -> Result<(), Vec<Diagnostic>> {
    let weights: Vec<f64> = system.exact().into_iter().map(|exact| if exact { initial::EXACT } else { 1.0 }).collect();
    let failed = |failure: Failure| {
        let note = "the initial positions and velocities must satisfy the joints and motions";
        vec![failed(&failure).note(note)]
    };
    initial::displacements(system, state, &weights).map_err(failed)?;
    initial::velocities(system, state, &weights).map_err(failed)?;
    Ok(())
}

/// What Adams says at the start of a run of joints whose markers are apart: displacement of I from J
/// in J axes.
fn apart(system: &mut System, state: &SystemState, units: &UnitSystem) -> Vec<Diagnostic> {
    let (q, v) = (state.q.clone(), state.v.clone());
    system.state(state.t, &q, &v, None);
    let unit = units.length.si;
    let mut warnings = Vec::new();
    for constraint in system.constraint_list() {
        let coincident = (0..constraint.equations())
            .filter(|e| ["X", "Y", "Z"].contains(&constraint.equation_name(*e).0.as_str()))
            .count()
            == 3;
        let (Some(i), Some(j), true) = (constraint.frame(Side::I), constraint.frame(Side::J), coincident) else {
            continue;
        };
        let d = relative(system.last_state(), i, j).d_ji_j / unit;
        // Exports carry ten digits; what is smaller is no displacement.
        if d.length() > 1e-6 * (system.size() / unit).max(1.0) {
            let name = constraint.name().trim_start_matches('.');
            let [x, y, z] = d.to_array().map(|x| x + 0.0);
            let message = format!(
                "The markers for {name} are not initially coincident. The relative displacement between the markers, \
                 expressed in the J marker coordinate frame is: Delta X = {x:.4}  Delta Y = {y:.4}  Delta Z = {z:.4}. \
                 The parts are moved together."
            );
            warnings.push(
                Diagnostic::warning("run/markers-apart", message)
                    .adams(format!("The markers for {name} are not initially coincident."))
                    .adams("The relative displacement between the markers, expressed in the")
                    .adams("J marker coordinate frame is:")
                    .adams(format!("Delta X = {x:8.4}   Delta Y = {y:8.4}  Delta Z = {z:8.4}.")),
            );
        }
    }
    warnings
}

/// What Adams says at the start of a run of parts whose inertias are of very different size.
fn odd_inertias(database: &Database, model: ObjectId) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for part in database.below(model, "part") {
        let given: Vec<f64> = ["ixx", "iyy", "izz"].into_iter().filter_map(|i| database.si(part, i)).collect();
        let (least, most) = given.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(*x), b.max(*x)));
        if given.len() == 3 && least > 0.0 && most > 1e4 * least && database.flag(part, "active") != Some(false) {
            let full = database.full_name(part);
            let name = full.trim_start_matches('.');
            let message = format!(
                "IP data specified for PART {name} may not be physically meaningful, since two inertias differ by more \
                 than four orders of magnitude."
            );
            warnings.push(
                Diagnostic::warning("run/odd-inertias", message)
                    .adams(format!("IP data specified for PART {name} "))
                    .adams("may not be physically meaningful, since two Inertias differ by more ")
                    .adams("than four orders of magnitude."),
            );
        }
    }
    warnings
}

/// Equations that were switched off because others say the same must hold all the same, in position
/// and in velocity.
fn contradictions(system: &mut System, state: &SystemState) -> Result<(), Vec<Diagnostic>> {
    let rows = system.constraint_rows(state.t, &state.q).map_err(|e| vec![evaluation(&e)])?;
    let length = system.size().max(1.0);
    let mut rates = std::collections::BTreeMap::new();
    let last = system.last_state();
    for (index, constraint) in system.constraint_list().iter().enumerate() {
        let mut rate = vec![0.0; constraint.equations()];
        constraint.velocity(last, &mut rate);
        rates.insert(index, rate);
    }
    let mut errors = Vec::new();
    for row in rows.iter().filter(|row| !row.active) {
        let speed: f64 = row.entries.iter().map(|(column, value)| value * state.v[*column]).sum();
        let rate = speed + rates[&row.constraint][row.equation];
        let fast = row.entries.iter().map(|(column, value)| (value * state.v[*column]).abs()).fold(1.0, f64::max);
        if row.phi.abs() > 1e-6 * length || rate.abs() > 1e-6 * fast {
            let constraint = &system.constraint_list()[row.constraint];
            let (short, words) = constraint.equation_name(row.equation);
            let text = format!("`{}` contradicts other constraints: equation {short} cannot hold", constraint.name());
            let what = if row.phi.abs() > 1e-6 * length { "is off by" } else { "changes at a rate of" };
            let size = if row.phi.abs() > 1e-6 * length { row.phi } else { rate };
            errors.push(
                Diagnostic::error("run/contradictory-constraints", text)
                    .note(format!("{words} {what} {size:.6e} (SI) when the others hold"))
                    .help("remove one of the constraints that hold the same motion, or make them agree"),
            );
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(errors) }
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

/// Hands outputs to the observer and keeps them; notes what elements are concerned about.
struct Recorder<'a> {
    observer: &'a mut dyn RunObserver,
    outputs: elements::Outputs,
    table: Table,
    row: Vec<f64>,
    /// What elements were concerned about, in order of first appearance.
    concerns: Vec<Noted>,
    stopped: bool,
    start: f64,
}

impl Recorder<'_> {
    fn record(&mut self, system: &mut System, state: &SystemState) {
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
struct Noted {
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
fn concern_warnings(noted: &[Noted]) -> Vec<Diagnostic> {
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

pub(crate) fn evaluation(error: &solver::Evaluation) -> Diagnostic {
    Diagnostic::error("run/not-computable", error.message.clone())
}

pub(crate) fn failed(failure: &Failure) -> Diagnostic {
    Diagnostic::error("run/failed", failure.to_string()).adams("ERROR:  Simulation failure detected.")
}
