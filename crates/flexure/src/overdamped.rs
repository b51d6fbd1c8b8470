//! The trap of a beam's damping ratio: it is a time, and typed as if it were a modal damping ratio it
//! keeps a structure from swinging at all. One beam alone cannot tell (short pieces of a long chain are
//! overdamped by themselves and nobody misses it), so the lowest modes of the model do. They are found
//! by iteration, whose cost grows with the model and no faster.

use elements::Finding;
use model::{Database, ObjectId};
use schema::Dimension;
use solver::{Dae, LowMode, lowest_modes};
use text::Diagnostic;

use crate::modes::at_rest;
use crate::start::prepare;

/// Vectors to iterate: six rigid motions and some more at first; many if a model falls apart.
const VECTORS: [usize; 2] = [12, 60];

/// A warning if beams are damped and the lowest elastic mode of the model does not swing.
pub(crate) fn find(database: &Database, model: ObjectId) -> Option<Finding> {
    let ratio = |beam: &ObjectId| database.si(*beam, "damping_ratio").filter(|ratio| *ratio > 0.0);
    let matrix = |beam: &ObjectId| database.value(*beam, "matrix_of_damping_terms").is_some();
    let beams = database.below(model, "beam");
    let damped: Vec<(ObjectId, f64)> =
        beams.iter().filter(|b| !matrix(b)).filter_map(|b| Some((*b, ratio(b)?))).collect();
    let (beam, _) = *damped.iter().max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))?;
    let name = database.full_name(beam);
    match lowest(database, model)? {
        Lowest::Creeps(mode) => Some(overdamped(database, &damped, &name, mode)),
        Lowest::Swings => None,
        Lowest::OnlyRigid => Some(Finding::new(
            Diagnostic::new(
                text::Severity::Note,
                "beam/damping-not-looked-at",
                format!("whether `damping_ratio` of beam `{name}` keeps the model from swinging was not found out"),
            )
            .note(format!("the {} lowest motions of the model have no stiffness", VECTORS[1]))
            .help("`flexure modes` lists all modes with their damping"),
        )),
    }
}

/// How the lowest elastic modes move.
enum Lowest {
    Swings,
    /// None of them swings; the lowest.
    Creeps(LowMode),
    OnlyRigid,
}

/// `None` if the model cannot be lowered or has no modes, which is reported elsewhere.
fn lowest(database: &Database, model: ObjectId) -> Option<Lowest> {
    let mut prepared = prepare(database, model, None, elements::Options::default()).ok()?;
    let (system, state) = (&mut prepared.lowered.system, &mut prepared.state);
    at_rest(system, state).ok()?;
    for vectors in VECTORS {
        // One motion that swings is enough: the lowest mode is below it and damped less.
        let swings = |motion: &LowMode| motion.damping_ratio < 1.0;
        let modes = lowest_modes(system, state, vectors, swings).ok()?;
        let mut elastic = modes.into_iter().filter(|m| m.frequency > 0.0).peekable();
        if let Some(&lowest) = elastic.peek() {
            return Some(if elastic.any(|m| swings(&m)) { Lowest::Swings } else { Lowest::Creeps(lowest) });
        }
        if vectors >= system.velocities() {
            return None;
        }
    }
    Some(Lowest::OnlyRigid)
}

fn overdamped(database: &Database, damped: &[(ObjectId, f64)], name: &str, mode: LowMode) -> Finding {
    let LowMode { frequency: w, damping_ratio: zeta } = mode;
    let (unit, factor) = (database.units().label(Dimension::TIME), database.units().factor(Dimension::TIME));
    let typed = |ratio: f64| ratio / factor;
    let largest = damped.iter().map(|d| typed(d.1)).fold(0.0, f64::max);
    // The slow one of the two real roots, without the difference of nearly equal numbers.
    let creeps = w / (zeta + (zeta * zeta - 1.0).sqrt());
    let diagnostic = Diagnostic::warning(
        "beam/overdamped",
        format!("no mode of the model swings: `damping_ratio` of beam `{name}` is {largest} {unit}"),
    )
    .note(format!(
        "the lowest mode, {w:.4} rad/s without damping, has {zeta:.4} of its critical damping and creeps back with {creeps:.4} per second"
    ))
    .note("damping_ratio is a time: a mode of w rad/s gets the modal damping ratio damping_ratio * w / 2")
    .help(format!("for a modal damping of 1 percent of the lowest mode give {:.4e} {unit}", 0.02 / w / factor));
    let computed =
        damped.iter().any(|(beam, _)| database.cell(*beam, "damping_ratio").is_some_and(model::Cell::is_expression));
    if largest >= 1.0 || computed {
        let why = if computed {
            "the number comes from an expression"
        } else {
            "a modal damping ratio is below 1, so that the number is none"
        };
        return Finding::new(diagnostic.note(format!("no fix is offered: {why}")));
    }
    let commands: Vec<String> = damped
        .iter()
        .map(|(beam, ratio)| {
            let name = database.full_name(*beam);
            let time = 2.0 * typed(*ratio) / w / factor;
            format!("force modify element_like beam beam_name={name} damping_ratio={time:e}")
        })
        .collect();
    Finding::new(diagnostic.note("the fix takes the number for the modal damping ratio of the lowest mode"))
        .fixed_by(commands.join("\n"))
}
