//! The trap of a beam's damping ratio: it is a time, and typed as if it were a modal damping ratio it
//! keeps a structure from swinging at all. One beam alone cannot tell (short pieces of a long chain are
//! overdamped by themselves and nobody misses it), so the lowest modes of the model do: those in which
//! the damped beams take part, and of their damping what the beams themselves take. They are found by
//! iteration, whose cost grows with the model and no faster.

use std::collections::BTreeMap;

use elements::forces::beam::{
    lower::{active, ratio_in_use},
    schema::DAMPING_RATIO,
};
use elements::verify::modify;
use elements::{Finding, LoadId, Lowered};
use equations::System;
use model::{Database, ObjectId};
use schema::Dimension;
use solver::{Dae, Failure, Look, LowMode, LowestModes, SystemState};
use text::Diagnostic;

use crate::modes::at_rest;
use crate::start::{failed, prepare_lowered};

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

/// A finding for every group of damped beams that keeps all modes in which it takes part from swinging, and a
/// note for every group of which that was not found out.
pub(crate) fn find(database: &Database, model: ObjectId, lowered: Lowered) -> Vec<Finding> {
    let groups = groups(database, model);
    if groups.is_empty() {
        return Vec::new();
    }
    look_at(database, model, lowered, &groups).unwrap_or_else(|troubles| {
        let why = troubles.first().map_or("", |trouble| trouble.message.as_str());
        groups.iter().map(|group| unknown(database, group, format!("the modes cannot be computed: {why}"))).collect()
    })
}

/// Active beams with a ratio that is used, by ratios of one size, the largest first.
fn groups(database: &Database, model: ObjectId) -> Vec<Vec<Damped>> {
    let damped = |beam: ObjectId| {
        let ratio = ratio_in_use(database, beam).filter(|ratio| *ratio > 0.0 && ratio.is_finite())?;
        Some(Damped { beam, ratio })
    };
    let mut all: Vec<Damped> = active(database, model).into_iter().filter_map(damped).collect();
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

/// Errors if there is no state about which the model could be linearised.
fn look_at(
    database: &Database,
    model: ObjectId,
    lowered: Lowered,
    groups: &[Vec<Damped>],
) -> Result<Vec<Finding>, Vec<Diagnostic>> {
    let mut prepared = prepare_lowered(database, model, None, lowered)?;
    let loads = std::mem::take(&mut prepared.lowered.loads);
    let (system, state) = (&mut prepared.lowered.system, &mut prepared.state);
    let failed = |failure: Failure| vec![failed(&failure)];
    at_rest(system, state).map_err(failed)?;
    let mut search = LowestModes::new(system, state).map_err(failed)?;
    let mut findings = Vec::new();
    for group in groups {
        findings.push(match lowest(&mut search, system, state, group, &loads) {
            Ok(Lowest::Creeps(mode, taken)) => overdamped(database, group, &mode, taken),
            Ok(Lowest::Swings) => continue,
            Ok(Lowest::Unknown(why)) => unknown(database, group, why),
            Err(failure) => unknown(database, group, format!("the search for the lowest modes failed: {failure}")),
        });
    }
    Ok(findings)
}

/// How the lowest modes move in which a group of beams takes part.
enum Lowest {
    Swings,
    /// None of them swings: the lowest, and the part of its critical damping that the beams take.
    Creeps(LowMode, f64),
    /// Not found, and why.
    Unknown(String),
}

fn lowest(
    search: &mut LowestModes,
    system: &mut System,
    state: &SystemState,
    group: &[Damped],
    loads: &BTreeMap<ObjectId, LoadId>,
) -> Result<Lowest, Failure> {
    // Of a mode below this frequency the beams take less than its critical damping.
    let limit = group.first().map_or(0.0, |largest| 2.0 / largest.ratio);
    let mut why = String::new();
    for vectors in VECTORS {
        let found = search.find(vectors, |mode| {
            let beams = Share::of(system, state, mode, group, loads);
            match () {
                () if beams.energy < PART => Look::Other,
                () if beams.critical < 1.0 || mode.damping_ratio < 1.0 => Look::Enough(limit),
                () => Look::Wanted,
            }
        })?;
        if found.enough {
            return Ok(Lowest::Swings);
        }
        let settled = found.settled;
        if let Some(mode) = found.lowest.and_then(|at| found.modes.into_iter().nth(at)) {
            let taken = Share::of(system, state, &mode, group, loads).critical;
            // What the iteration met on its way was no mode yet.
            if taken < 1.0 || mode.damping_ratio < 1.0 {
                return Ok(Lowest::Swings);
            }
            if settled {
                return Ok(Lowest::Creeps(mode, taken));
            }
            why = format!(
                "the search for the lowest modes did not end: at {:.4} rad/s the lowest of them, without damping, still \
                 became lower",
                mode.frequency
            );
            continue;
        }
        if vectors >= system.velocities() {
            return Ok(Lowest::Swings);
        }
        why = format!("the beam has no part in the {vectors} lowest motions of the model");
    }
    Ok(Lowest::Unknown(why))
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

/// The beams of a group in a sentence.
fn beams(database: &Database, group: &[Damped]) -> String {
    let name = group.first().map(|first| database.full_name(first.beam)).unwrap_or_default();
    match group.len() {
        1 => format!("beam `{name}`"),
        n => format!("beam `{name}` and {} more", n - 1),
    }
}

/// A finding about a group, by its first beam.
fn about(group: &[Damped], diagnostic: Diagnostic) -> Finding {
    Finding { object: group.first().map(|first| first.beam), ..Finding::new(diagnostic) }
}

fn unknown(database: &Database, group: &[Damped], why: String) -> Finding {
    let them = if group.len() > 1 { "them" } else { "it" };
    let message = format!(
        "whether the `damping_ratio` of {} keeps {them} from swinging was not found out",
        beams(database, group)
    );
    let diagnostic = Diagnostic::new(text::Severity::Note, "beam/damping-not-looked-at", message)
        .note(why)
        .note("a damping far too large, as by a modal damping ratio typed where a time is wanted, would not be seen")
        .help("`flexure modes` lists all modes with their damping");
    about(group, diagnostic)
}

fn overdamped(database: &Database, group: &[Damped], mode: &LowMode, taken: f64) -> Finding {
    let (w, zeta) = (mode.frequency, mode.damping_ratio);
    let (unit, factor) = (database.units().label(Dimension::TIME), database.units().factor(Dimension::TIME));
    let typed = |ratio: f64| ratio / factor;
    let largest = group.first().map_or(0.0, |first| typed(first.ratio));
    // The slow one of the two real roots, without the difference of nearly equal numbers.
    let creeps = w / (zeta + (zeta * zeta - 1.0).sqrt());
    let take = if group.len() > 1 { "take" } else { "takes" };
    let diagnostic = Diagnostic::warning(
        "beam/overdamped",
        format!(
            "no mode in which {} {take} part swings: the `damping_ratio` is {largest} {unit}",
            beams(database, group)
        ),
    )
    .note(format!(
        "the lowest of these modes, {w:.4} rad/s without damping, has {zeta:.4} of its critical damping, {taken:.4} by \
         the damping ratio, and creeps back with {creeps:.4} per second"
    ))
    .note("damping_ratio is a time: a mode of w rad/s gets the modal damping ratio damping_ratio * w / 2")
    .help(format!("for a modal damping of 1 percent of that mode give {:.4e} {unit}", 0.02 / w / factor));
    let computed = group.iter().any(|d| database.cell(d.beam, DAMPING_RATIO).is_some_and(model::Cell::is_expression));
    if largest >= 1.0 || computed {
        let why = if computed {
            "the number comes from an expression"
        } else {
            "a modal damping ratio is below 1, so that the number is none"
        };
        return about(group, diagnostic.note(format!("no fix is offered: {why}")));
    }
    let commands: Vec<String> = group
        .iter()
        .map(|Damped { beam, ratio }| {
            let time = 2.0 * typed(*ratio) / w / factor;
            modify(database, *beam, format_args!("{DAMPING_RATIO}={time:e}"))
        })
        .collect();
    about(group, diagnostic.note("the fix takes the number for the modal damping ratio of that mode"))
        .fixed_by(commands.join("\n"))
}
