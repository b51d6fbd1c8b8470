//! The trap of a beam's damping ratio: it is a time, and typed as if it were a modal damping ratio it
//! keeps a structure from swinging at all. One beam alone cannot tell (short pieces of a long chain are
//! overdamped by themselves and nobody misses it), so the modes of the model do.

use elements::Finding;
use model::{Database, ObjectId};
use schema::Dimension;
use text::Diagnostic;

use crate::modes::{self, ModesAbout};
use crate::run::Silent;

/// Models with more parts are not looked at: the dense modes would take longer than all other checks.
const MOST_PARTS: usize = 60;

/// A warning if beams are damped and not one mode of the model swings.
pub(crate) fn find(database: &Database, model: ObjectId) -> Option<Finding> {
    let ratio = |beam: &ObjectId| database.si(*beam, "damping_ratio").filter(|ratio| *ratio > 0.0);
    let beams = database.below(model, "beam");
    let (beam, ratio) =
        beams.iter().filter_map(|b| Some((*b, ratio(b)?))).max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))?;
    if database.below(model, "part").len() > MOST_PARTS {
        return None;
    }
    let options = elements::Options::default();
    let found = modes::find(database, model, None, &ModesAbout::Present, options, &mut Silent).ok()?.modes;
    let elastic = |m: &&modes::Mode| m.real.hypot(m.imaginary) > 1e-3;
    let slowest = found.iter().find(elastic)?;
    // Many overdamped motions creep at nearly the same rate; rounding gives such roots a tiny imaginary part.
    let swings = |m: &modes::Mode| m.imaginary > 0.01 * m.real.abs();
    if found.iter().filter(elastic).any(swings) || slowest.real >= 0.0 {
        return None;
    }
    let name = database.full_name(beam);
    let (unit, factor) = (database.units().label(Dimension::TIME), database.units().factor(Dimension::TIME));
    Some(Finding::new(
        Diagnostic::warning(
            "beam/overdamped",
            format!("no mode of the model swings: `damping_ratio` of beam `{name}` is {} {unit}", ratio / factor),
        )
        .note(format!("the slowest motion creeps back with {:.4} per second", -slowest.real))
        .note("damping_ratio is a time: a mode of w rad/s gets the modal damping ratio damping_ratio * w / 2")
        .help("for a modal damping of 1 percent at w rad/s give 0.02 / w"),
    ))
}
