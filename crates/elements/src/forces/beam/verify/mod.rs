//! The well-known traps of beams, found before anything is solved. Most wrong beams are accepted by
//! every program and give results that look like results.
//!
//! A finding carries the command that mends it where that command is certain to be right; where it
//! would have to guess, a note begins with `no fix is offered:` and says what is not known.

mod data;
mod doubtful;
mod place;
mod torsion;

use model::{Database, ObjectId};
use text::Diagnostic;

use super::lower::{ends, section};
use crate::Options;
use crate::verify::{Finding, modify};

pub fn verify(database: &Database, beam: ObjectId, options: &Options, findings: &mut Vec<Finding>) {
    let section = section(database, beam);
    let ends = ends(database, beam);
    let placement = match ends {
        [Some(i), Some(j)] => Some(place::Placement::of(database, i, j, options.beam_angles)),
        _ => None,
    };
    data::find(database, beam, &section, placement.as_ref(), findings);
    let ([Some(i), Some(j)], Some(placement)) = (ends, placement) else { return };
    let name = database.full_name(beam);
    if i == j || database.object(i).parent == database.object(j).parent {
        let part = database.object(i).parent.map(|p| database.full_name(p)).unwrap_or_default();
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/one-part",
                format!("both markers of beam `{name}` are on the same part, `{part}`"),
            )
            .note("the two ends cannot move relative to each other: the beam has no effect on the motion")
            .note("no fix is offered: which part the other end belongs to is not in the model")
            .help(modify(database, beam, format_args!("j_marker_name=... with a marker on another part"))),
        ));
    }
    if section.length > 0.0 && section.length.is_finite() {
        place::find(database, beam, &section, &placement, findings);
    }
}

/// A number for a command: so many digits that nothing is lost but the noise of the last ones.
fn exact(value: f64) -> String {
    let rounded: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    format!("{rounded:?}").trim_end_matches(".0").to_string()
}
