//! The start of every analysis: a model as equations, without redundant ones, at a consistent state.

use elements::{Lowered, Options};
use equations::{Side, System, relative};
use model::{Database, ObjectId};
use schema::UnitSystem;
use solver::redundancy::{self, SparseRows};
use solver::{Dae, Failure, SystemState, initial};
use text::Diagnostic;

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

/// Lowers a model, switches redundant equations off and finds a consistent state.
pub(crate) fn prepare(
    database: &Database,
    model: ObjectId,
    from: Option<SystemState>,
    lowering: Options,
) -> Result<Prepared, Vec<Diagnostic>> {
    prepare_lowered(database, model, from, elements::lower(database, model, lowering)?)
}

/// The same for a model that was lowered already.
pub(crate) fn prepare_lowered(
    database: &Database,
    model: ObjectId,
    from: Option<SystemState>,
    mut lowered: Lowered,
) -> Result<Prepared, Vec<Diagnostic>> {
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

/// Share of the model's size (at least 1 m), and of the largest speed in an equation, by which an equation
/// that was switched off may fail: what models written with six digits leave of equations that agree.
const APART: f64 = 1e-6;

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
        let off = row.phi.abs() > APART * length;
        if off || rate.abs() > APART * fast {
            let constraint = &system.constraint_list()[row.constraint];
            let (short, words) = constraint.equation_name(row.equation);
            let text = format!("`{}` contradicts other constraints: equation {short} cannot hold", constraint.name());
            let (what, size) = if off { ("is off by", row.phi) } else { ("changes at a rate of", rate) };
            errors.push(
                Diagnostic::error("run/contradictory-constraints", text)
                    .note(format!("{words} {what} {size:.6e} (SI) when the others hold"))
                    .help("remove one of the constraints that hold the same motion, or make them agree"),
            );
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(errors) }
}

pub(crate) fn evaluation(error: &solver::Evaluation) -> Diagnostic {
    Diagnostic::error("run/not-computable", error.message.clone())
}

pub(crate) fn failed(failure: &Failure) -> Diagnostic {
    Diagnostic::error("run/failed", failure.to_string()).adams("ERROR:  Simulation failure detected.")
}
