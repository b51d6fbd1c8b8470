//! The trap of a beam's damping ratio: it is a time, and typed as if it were a modal damping ratio it
//! keeps a structure from swinging at all. One beam alone cannot tell (short pieces of a long chain are
//! overdamped by themselves and nobody misses it), so the lowest modes of the model do: those in which
//! the damped beams take part, and of their damping what the beams themselves take. They are found by
//! iteration, whose cost grows with the model and no faster.

use std::collections::BTreeMap;

use elements::{Finding, LoadId};
use equations::System;
use model::{Database, ObjectId};
use schema::Dimension;
use solver::{Dae, Look, LowMode, LowestModes, SystemState};
use text::Diagnostic;

use crate::modes::at_rest;
use crate::start::prepare;

/// Vectors to iterate: six rigid motions and some more at first; many if a model falls apart.
const VECTORS: [usize; 2] = [12, 60];
/// Share of a mode's strain energy from which on beams take part in it.
const PART: f64 = 0.1;
/// Beams whose ratios differ by less than this factor are looked at together; a small ratio beside a
/// large one is no slip of the same kind.
const ALIKE: f64 = 10.0;

/// A beam with a damping ratio.
struct Damped {
    beam: ObjectId,
    /// s
    ratio: f64,
}

/// A finding for every group of damped beams that keeps all modes in which it takes part from swinging.
pub(crate) fn find(database: &Database, model: ObjectId) -> Vec<Finding> {
    let groups = groups(database, model);
    if groups.is_empty() {
        return Vec::new();
    }
    look_at(database, model, &groups).unwrap_or_default()
}

/// Active beams with a ratio that is used, by ratios of one size, the largest first.
fn groups(database: &Database, model: ObjectId) -> Vec<Vec<Damped>> {
    let damped = |beam: ObjectId| {
        let ratio = database.si(beam, "damping_ratio").filter(|ratio| *ratio > 0.0 && ratio.is_finite())?;
        // The terms of a matrix win over the ratio.
        database.value(beam, "matrix_of_damping_terms").is_none().then_some(Damped { beam, ratio })
    };
    let mut all: Vec<Damped> = elements::active_objects(database, model)
        .into_iter()
        .filter(|&id| database.object(id).class.id == "beam")
        .filter_map(damped)
        .collect();
    all.sort_by(|p, q| q.ratio.total_cmp(&p.ratio).then(p.beam.cmp(&q.beam)));
    let mut groups: Vec<Vec<Damped>> = Vec::new();
    for beam in all {
        match groups.last_mut() {
            Some(group) if group.first().is_some_and(|first| first.ratio <= ALIKE * beam.ratio) => group.push(beam),
            _ => groups.push(vec![beam]),
        }
    }
    groups
}

/// `None` if the model cannot be lowered or linearised, which is reported elsewhere.
fn look_at(database: &Database, model: ObjectId, groups: &[Vec<Damped>]) -> Option<Vec<Finding>> {
    let mut prepared = prepare(database, model, None, elements::Options::default()).ok()?;
    let loads = std::mem::take(&mut prepared.lowered.loads);
    let (system, state) = (&mut prepared.lowered.system, &mut prepared.state);
    at_rest(system, state).ok()?;
    let mut search = LowestModes::new(system, state).ok()?;
    let mut findings = Vec::new();
    for group in groups {
        match lowest(&mut search, system, state, group, &loads)? {
            Lowest::Creeps(mode, taken) => findings.push(overdamped(database, group, &mode, taken)),
            Lowest::Swings => continue,
            Lowest::Unknown => findings.push(unknown(database, group)),
        }
        if let (Some(finding), Some(first)) = (findings.last_mut(), group.first()) {
            finding.object = Some(first.beam);
        }
    }
    Some(findings)
}

/// How the lowest modes move in which a group of beams takes part.
enum Lowest {
    Swings,
    /// None of them swings: the lowest, and the part of its critical damping that the beams take.
    Creeps(LowMode, f64),
    /// Not among those that were found.
    Unknown,
}

fn lowest(
    search: &mut LowestModes,
    system: &mut System,
    state: &SystemState,
    group: &[Damped],
    loads: &BTreeMap<ObjectId, LoadId>,
) -> Option<Lowest> {
    for vectors in VECTORS {
        let found = search
            .find(vectors, |mode| {
                let beams = Share::of(system, state, mode, group, loads);
                match () {
                    () if beams.energy < PART => Look::Other,
                    () if beams.critical < 1.0 || mode.damping_ratio < 1.0 => Look::Enough,
                    () => Look::Wanted,
                }
            })
            .ok()?;
        if found.enough {
            return Some(Lowest::Swings);
        }
        if let Some(mode) = found.lowest.and_then(|at| found.modes.into_iter().nth(at)) {
            let taken = Share::of(system, state, &mode, group, loads).critical;
            // What the iteration met on its way was no mode yet.
            let swings = taken < 1.0 || mode.damping_ratio < 1.0;
            return Some(if swings { Lowest::Swings } else { Lowest::Creeps(mode, taken) });
        }
        if vectors >= system.velocities() {
            return Some(Lowest::Swings);
        }
    }
    Some(Lowest::Unknown)
}

/// What beams have of a mode.
struct Share {
    /// Part of the strain energy.
    energy: f64,
    /// Part of the critical damping.
    critical: f64,
}

impl Share {
    /// A beam takes `ratio v K v` where the model moves with v; the shape has one unit of `v M v`.
    fn of(
        system: &mut System,
        state: &SystemState,
        mode: &LowMode,
        group: &[Damped],
        loads: &BTreeMap<ObjectId, LoadId>,
    ) -> Share {
        system.state(state.t, &state.q, &mode.shape, None);
        let (mut stiffness, mut damping) = (0.0, 0.0);
        for Damped { beam, ratio } in group {
            let Some(LoadId::Force(at)) = loads.get(beam) else { continue };
            let power = system.force_list().get(*at).map_or(0.0, |force| force.dissipation(system.last_state()));
            damping += power;
            stiffness += power / ratio;
        }
        let w = mode.frequency;
        Share { energy: stiffness / (w * w), critical: damping / (2.0 * w) }
    }
}

/// The beams of a group in a sentence, with the verb.
fn take(database: &Database, group: &[Damped]) -> String {
    let name = group.first().map(|first| database.full_name(first.beam)).unwrap_or_default();
    match group.len() {
        1 => format!("beam `{name}` takes"),
        n => format!("beam `{name}` and {} more take", n - 1),
    }
}

fn unknown(database: &Database, group: &[Damped]) -> Finding {
    let name = group.first().map(|first| database.full_name(first.beam)).unwrap_or_default();
    Finding::new(
        Diagnostic::new(
            text::Severity::Note,
            "beam/damping-not-looked-at",
            format!("whether `damping_ratio` of beam `{name}` keeps it from swinging was not found out"),
        )
        .note(format!("the beam has no part in the {} lowest motions of the model", VECTORS[1]))
        .help("`flexure modes` lists all modes with their damping"),
    )
}

fn overdamped(database: &Database, group: &[Damped], mode: &LowMode, taken: f64) -> Finding {
    let (w, zeta) = (mode.frequency, mode.damping_ratio);
    let (unit, factor) = (database.units().label(Dimension::TIME), database.units().factor(Dimension::TIME));
    let typed = |ratio: f64| ratio / factor;
    let largest = group.first().map_or(0.0, |first| typed(first.ratio));
    // The slow one of the two real roots, without the difference of nearly equal numbers.
    let creeps = w / (zeta + (zeta * zeta - 1.0).sqrt());
    let diagnostic = Diagnostic::warning(
        "beam/overdamped",
        format!("no mode in which {} part swings: the `damping_ratio` is {largest} {unit}", take(database, group)),
    )
    .note(format!(
        "the lowest of these modes, {w:.4} rad/s without damping, has {zeta:.4} of its critical damping, {taken:.4} by \
         the damping ratio, and creeps back with {creeps:.4} per second"
    ))
    .note("damping_ratio is a time: a mode of w rad/s gets the modal damping ratio damping_ratio * w / 2")
    .help(format!("for a modal damping of 1 percent of that mode give {:.4e} {unit}", 0.02 / w / factor));
    let computed = group.iter().any(|d| database.cell(d.beam, "damping_ratio").is_some_and(model::Cell::is_expression));
    if largest >= 1.0 || computed {
        let why = if computed {
            "the number comes from an expression"
        } else {
            "a modal damping ratio is below 1, so that the number is none"
        };
        return Finding::new(diagnostic.note(format!("no fix is offered: {why}")));
    }
    let commands: Vec<String> = group
        .iter()
        .map(|Damped { beam, ratio }| {
            let name = database.full_name(*beam);
            let time = 2.0 * typed(*ratio) / w / factor;
            format!("force modify element_like beam beam_name={name} damping_ratio={time:e}")
        })
        .collect();
    Finding::new(diagnostic.note("the fix takes the number for the modal damping ratio of that mode"))
        .fixed_by(commands.join("\n"))
}
