//! Section data that cannot be, or hardly can be, what was meant.

use model::{Database, ObjectId};
use schema::Dimension;
use text::Diagnostic;

use super::{doubtful, exact, place::Placement, torsion};
use crate::forces::beam::{
    lower::{law, ratio_in_use, wrong_data},
    physics::Section,
    schema::DAMPING_RATIO,
};
use crate::verify::{Finding, modify, number};

pub(super) fn find(
    database: &Database,
    beam: ObjectId,
    s: &Section,
    at: Option<&Placement>,
    findings: &mut Vec<Finding>,
) {
    let name = database.full_name(beam);
    let first = findings.len();
    for (cell, diagnostic) in wrong_data(database, beam, s) {
        findings.push(mended(database, beam, cell, diagnostic, at));
    }
    // What else makes the beam no beam: its damping.
    for trouble in law(database, beam, false).err().into_iter().flatten() {
        if !findings[first..].iter().any(|f| f.diagnostic.message == trouble.message) {
            findings.push(Finding::new(trouble));
        }
    }
    shear_ratios(database, beam, s, findings);
    ones(database, beam, &name, findings);
    polar_moment(database, beam, s, findings);
    doubtful::find(database, beam, s, findings);
    damping_twice(database, beam, &name, findings);
}

/// A number that is not positive: a length follows from the markers, and a number that is only
/// negative has lost nothing but its sign.
fn mended(
    database: &Database,
    beam: ObjectId,
    cell: &'static str,
    diagnostic: Diagnostic,
    at: Option<&Placement>,
) -> Finding {
    let command = |value: f64| modify(database, beam, format_args!("{cell}={}", exact(value)));
    let value = database.number(beam, cell).unwrap_or(0.0);
    let computed = database.cell(beam, cell).is_some_and(model::Cell::is_expression);
    let distance = at.map(|at| at.r_ji_j.length() / database.units().factor(Dimension::LENGTH));
    match distance.filter(|d| cell == "length" && *d > 0.0) {
        Some(distance) => Finding::new(diagnostic.note("its markers are as far apart as the length that is offered"))
            .fixed_by(command(distance)),
        None if value.is_finite() && value < 0.0 && !computed => {
            Finding::new(diagnostic.note("the fix takes the sign away")).fixed_by(command(-value))
        }
        None if computed => Finding::new(diagnostic.note("no fix is offered: the number comes from an expression")),
        None => Finding::new(diagnostic.note("no fix is offered: the right number is not in the model")),
    }
}

fn shear_ratios(database: &Database, beam: ObjectId, s: &Section, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    for (cell, ratio) in [("y_shear_area_ratio", s.asy), ("z_shear_area_ratio", s.asz)] {
        if ratio <= 0.0 || ratio >= 1.0 {
            continue;
        }
        let diagnostic = Diagnostic::warning(
            "beam/shear-ratio",
            format!("`{cell}` of beam `{name}` is {}, which is not possible below 1", number(ratio)),
        )
        .note("it is the area over the shear area: 6/5 for a rectangle, 10/9 for a circle, 2 for a thin tube");
        let inverse = 1.0 / ratio;
        findings.push(if inverse.is_finite() {
            let help = format!("give the inverse, {}, or 0 for no shear deflection", number(inverse));
            Finding::new(diagnostic.help(help)).fixed_by(modify(
                database,
                beam,
                format_args!("{cell}={}", exact(inverse)),
            ))
        } else {
            Finding::new(
                diagnostic
                    .note("no fix is offered: the inverse of the ratio is no number")
                    .help("give 0 for no shear deflection"),
            )
        });
    }
}

fn ones(database: &Database, beam: ObjectId, name: &str, findings: &mut Vec<Finding>) {
    let is_one = |cell: &str| database.number(beam, cell).is_none_or(|x| x == 1.0);
    let cells = ["length", "area_of_cross_section", "youngs_modulus", "shear_modulus", "ixx", "iyy", "izz"];
    let ones: Vec<_> = cells.into_iter().filter(|cell| is_one(cell)).collect();
    if ones.is_empty() {
        return;
    }
    let wanted: Vec<String> = ones.iter().map(|cell| format!("{cell}=...")).collect();
    findings.push(Finding::new(
        Diagnostic::warning(
            "beam/default-of-one",
            format!("`{}` of beam `{name}` is 1, the default", ones.join("`, `")),
        )
        .note("a beam that is given no value gets 1 in the model's units")
        .note("no fix is offered: the value that was forgotten is not in the model")
        .help(modify(database, beam, format_args!("{}; ignore this if 1 is meant", wanted.join(" ")))),
    ));
}

/// Largest difference, as a share, of a torsion constant that is the polar moment: numbers are typed with six
/// digits.
const ROUND: f64 = 1e-6;

fn polar_moment(database: &Database, beam: ObjectId, s: &Section, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    let polar = s.iyy + s.izz;
    // With second moments that differ by a share e of their sum, the torsion constant of a solid section is
    // smaller than the polar moment by the square of e and no more.
    let round = (s.iyy - s.izz).powi(2) <= ROUND * polar.powi(2);
    if s.iyy <= 0.0 || s.izz <= 0.0 || round || (s.ixx - polar).abs() >= ROUND * polar {
        return;
    }
    let in_model = |value: f64| value / database.units().factor(Dimension::AREA_INERTIA);
    let shown = |value: f64| number(in_model(value));
    let diagnostic = Diagnostic::warning(
        "beam/polar-moment",
        format!(
            "`ixx` of beam `{name}` is {}, the polar moment iyy + izz of a section that is not round",
            shown(s.ixx)
        ),
    )
    .note(format!(
        "iyy is {} and izz is {} {}",
        shown(s.iyy),
        shown(s.izz),
        database.units().label(Dimension::AREA_INERTIA)
    ))
    .note("ixx is the torsion constant, which is smaller than the polar moment unless the section is round");
    findings.push(match torsion::of_solid(s.area, s.iyy, s.izz) {
        Some(found) => Finding::new(
            diagnostic.help(format!("a solid section twists with ixx = {}, {}", shown(found.constant), found.source)),
        )
        .fixed_by(modify(database, beam, format_args!("ixx={}", exact(in_model(found.constant))))),
        None => Finding::new(
            diagnostic
                .note("no fix is offered: area and moments are not those of a solid section, and only its walls tell the torsion constant of another one")
                .help("`flexure section` computes it from the dimensions of the section"),
        ),
    });
}

fn damping_twice(database: &Database, beam: ObjectId, name: &str, findings: &mut Vec<Finding>) {
    let ratio = database.number(beam, DAMPING_RATIO).unwrap_or(0.0);
    if ratio != 0.0 && ratio_in_use(database, beam).is_none() {
        findings.push(
            Finding::new(
                Diagnostic::warning("beam/damping-twice", format!("the damping of beam `{name}` is given twice"))
                    .note(format!("`matrix_of_damping_terms` is used and `damping_ratio`, {}, is not", number(ratio)))
                    .help("set `damping_ratio` to 0, as the fix does; for the ratio instead, create the beam anew without the matrix: no command takes a matrix away"),
            )
            .fixed_by(modify(database, beam, format_args!("{DAMPING_RATIO}=0"))),
        );
    }
}
