//! Numbers that no section, no isotropic material and no damper has. Which of them is wrong is not in the
//! model, so that none of these findings has a fix.

use model::{Database, ObjectId};
use schema::Dimension;
use solver::dense::{Matrix, eigenpairs};
use text::Diagnostic;

use crate::forces::beam::physics::{Mat6, Section, from_lower_triangle};
use crate::forces::beam::schema::DAMPING_MATRIX;
use crate::verify::{Finding, modify, number};

/// Excess of the torsion constant over the polar moment that numbers of three digits may have.
const THREE_DIGITS: f64 = 0.01;
/// How far Poisson's ratio may be out of its range: two moduli of four digits.
const FOUR_DIGITS: f64 = 1e-3;
/// Eigenvalue of a damping matrix with ones on its diagonal that is rounding of zero.
const ROUNDING: f64 = 1e-9;

pub(super) fn find(database: &Database, beam: ObjectId, s: &Section, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    let default = |cell: &str| database.number(beam, cell).is_none_or(|x| x == 1.0);
    zeros(database, beam, s, findings);
    // A default of one that was left is reported as such.
    if !["ixx", "iyy", "izz"].into_iter().any(default) {
        torsion_constant(database, &name, s, findings);
    }
    if !["youngs_modulus", "shear_modulus"].into_iter().any(default) {
        moduli(&name, s, findings);
    }
    if let Some(Ok(terms)) = database.numbers(beam, DAMPING_MATRIX).map(|t| <[f64; 21]>::try_from(&*t)) {
        damping_matrix(&name, &from_lower_triangle(&terms), findings);
    }
}

fn zeros(database: &Database, beam: ObjectId, s: &Section, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    let effects = [("ixx", s.ixx, "twisting"), ("iyy", s.iyy, "bending about y"), ("izz", s.izz, "bending about z")];
    for (cell, _, effect) in effects.into_iter().filter(|(_, value, _)| *value == 0.0) {
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/zero-moment",
                format!("`{cell}` of beam `{name}` is 0: nothing resists {effect}"),
            )
            .note("no fix is offered: the right number is not in the model")
            .help(modify(database, beam, format_args!("{cell}=...; ignore this if 0 is meant"))),
        ));
    }
}

/// Truth of all sections: the torsion constant is at most the polar moment, which only round ones reach.
fn torsion_constant(database: &Database, name: &str, s: &Section, findings: &mut Vec<Finding>) {
    let polar = s.iyy + s.izz;
    if s.iyy <= 0.0 || s.izz <= 0.0 || !s.ixx.is_finite() || s.ixx <= polar * (1.0 + THREE_DIGITS) {
        return;
    }
    let shown = |value: f64| number(value / database.units().factor(Dimension::AREA_INERTIA));
    findings.push(Finding::new(
        Diagnostic::warning(
            "beam/torsion-constant",
            format!("`ixx` of beam `{name}` is {}, more than iyy + izz, {}", shown(s.ixx), shown(polar)),
        )
        .note("ixx is the torsion constant, which no section has larger than its polar moment iyy + izz")
        .note("no fix is offered: which of the three numbers is wrong is not in the model")
        .help("`flexure section` computes all three from the dimensions of the section"),
    ));
}

fn moduli(name: &str, s: &Section, findings: &mut Vec<Finding>) {
    let poisson = s.e / (2.0 * s.g) - 1.0;
    if s.e <= 0.0 || s.g <= 0.0 || !poisson.is_finite() || (-FOUR_DIGITS..=0.5 + FOUR_DIGITS).contains(&poisson) {
        return;
    }
    findings.push(Finding::new(
        Diagnostic::warning(
            "beam/moduli",
            format!(
                "the moduli of beam `{name}` are those of no common material: Poisson's ratio would be {}",
                number(poisson)
            ),
        )
        .note("an isotropic material has youngs_modulus / (2 shear_modulus) - 1, between 0 and 0.5")
        .note("no fix is offered: which of the two moduli is wrong is not in the model")
        .help(
            "ignore this where the moduli differ on purpose: wood, composites, a beam that stands for something else",
        ),
    ));
}

/// A damper takes energy from every motion: a matrix that gives energy to one is no damper's.
fn damping_matrix(name: &str, c: &Mat6, findings: &mut Vec<Finding>) {
    if c.iter().flatten().any(|x| !x.is_finite()) {
        return;
    }
    // Units of the rows differ: with ones on the diagonal they compare.
    let largest = c.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let scale: [f64; 6] = std::array::from_fn(|k| {
        let of_row = c[k].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        match c[k][k].abs() {
            own if own > 0.0 => own.sqrt(),
            _ if of_row > 0.0 => of_row.sqrt(),
            _ => largest.sqrt().max(f64::MIN_POSITIVE),
        }
    });
    let scaled = Matrix::from_fn(6, 6, |i, j| c[i][j] / (scale[i] * scale[j]));
    let Some(pairs) = eigenpairs(scaled) else { return };
    let Some(worst) = pairs.iter().min_by(|p, q| p.value[0].total_cmp(&q.value[0])) else { return };
    if worst.value[0] >= -ROUNDING {
        return;
    }
    let direction: Vec<f64> = worst.vector.iter().zip(scale).map(|(x, s)| x[0] / s).collect();
    let size = direction.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let motion: Vec<f64> =
        direction.iter().map(|x| if x.abs() < 1e-9 * size { 0.0 } else { (x / size * 1e6).round() / 1e6 }).collect();
    let power: f64 =
        (0..6).flat_map(|i| (0..6).map(move |j| (i, j))).map(|(i, j)| motion[i] * c[i][j] * motion[j]).sum();
    let three = |v: &[f64]| v.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ");
    findings.push(Finding::new(
        Diagnostic::warning(
            "beam/damping-feeds",
            format!("`matrix_of_damping_terms` of beam `{name}` gives energy to a motion instead of taking it"),
        )
        .note(format!(
            "velocities of I from J of {} and rates of rotation of {} take the power {} (model units, radians)",
            three(&motion[..3]),
            three(&motion[3..]),
            number(power)
        ))
        .note(format!(
            "with ones on its diagonal the matrix has the eigenvalue {}; none may be below 0",
            number(worst.value[0])
        ))
        .note("no fix is offered: which of the terms is wrong is not in the model"),
    ));
}
