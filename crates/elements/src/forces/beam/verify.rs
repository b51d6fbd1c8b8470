//! The well-known traps of beams, found before anything is solved. Most wrong beams are accepted by
//! every program and give results that look like results.

use glam::DVec3;
use model::{Database, ObjectId, Pose};
use schema::Dimension;
use text::Diagnostic;

use super::{
    SMALL_ANGLE,
    lower::{law, section},
    physics::{Law, Section, projected_angles},
};
use crate::verify::{Finding, number};

/// Smallest distance from the axis, as a share of the length, that counts as off the axis.
const OFF_AXIS: f64 = 1e-3;
/// Smallest difference of length, as a share of it, that counts as a preload.
const PRELOAD: f64 = 1e-6;

pub fn verify(database: &Database, beam: ObjectId, findings: &mut Vec<Finding>) {
    let section = section(database, beam);
    data(database, beam, &section, findings);
    let ends = ["i_marker_name", "j_marker_name"].map(|cell| database.reference(beam, cell));
    let [Some(i), Some(j)] = ends else { return };
    let name = database.full_name(beam);
    if i == j || database.object(i).parent == database.object(j).parent {
        findings.push(Finding::new(
            Diagnostic::warning("beam/one-part", format!("both markers of beam `{name}` are on the same part"))
                .note("the two ends cannot move relative to each other: the beam has no effect on the motion")
                .help("use markers on two different parts"),
        ));
    }
    let placement = Placement::of(database, i, j);
    if section.length > 0.0 && section.length.is_finite() {
        place(database, beam, &section, &placement, findings);
    }
}

/// I as seen from J, m.
struct Placement {
    r_ji_j: DVec3,
    angles: [f64; 3],
    i: String,
    j: String,
}

impl Placement {
    fn of(database: &Database, i: ObjectId, j: ObjectId) -> Placement {
        let seen: Pose = database.global_pose(j).inverse().then(&database.global_pose(i));
        Placement {
            r_ji_j: seen.origin * database.units().factor(Dimension::LENGTH),
            angles: projected_angles(&seen.rotation),
            i: database.full_name(i),
            j: database.full_name(j),
        }
    }
}

/// Where I lies in J, and what follows for the load at the start.
fn place(database: &Database, beam: ObjectId, s: &Section, at: &Placement, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    let unit = database.units().length;
    let in_model = |metres: f64| number(metres / unit.si);
    let length = s.length;
    let distance = at.r_ji_j.length();
    let across = at.r_ji_j.y.hypot(at.r_ji_j.z);
    let Placement { i, j, .. } = at;
    if distance < 1e-9 * length {
        findings.push(Finding::new(
            Diagnostic::error("beam/coincident-markers", format!("the markers of beam `{name}` coincide"))
                .note(format!(
                    "I is `{i}`, J is `{j}`; undeformed, I lies at +{} {} along x of J",
                    in_model(length),
                    unit.name
                ))
                .help("move one of the markers, or use a bushing for two points in one place"),
        ));
        return;
    }
    if at.r_ji_j.x < 0.0 && across <= at.r_ji_j.x.abs() {
        let x = in_model(at.r_ji_j.x);
        findings.push(
            Finding::new(
                Diagnostic::error(
                    "beam/ends-swapped",
                    format!("I and J of beam `{name}` are swapped: I lies on -x of J, at x = {x} {}", unit.name),
                )
                .note(format!(
                    "I is `{i}`, J is `{j}`; undeformed, I must lie at +{} {} along x of J",
                    in_model(length),
                    unit.name
                ))
                .note(format!(
                    "as it is, the beam starts {} {} shorter than its free length",
                    in_model(length - at.r_ji_j.x),
                    unit.name
                ))
                .help("exchange the I and the J marker"),
            )
            .fixed_by(format!("force modify element_like beam beam_name={name} i_marker_name={j} j_marker_name={i}")),
        );
        return;
    }
    if across > OFF_AXIS * length {
        let degrees = across.atan2(at.r_ji_j.x).to_degrees();
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/off-axis",
                format!("I of beam `{name}` lies {} degrees off the x axis of J", number(degrees)),
            )
            .note(format!(
                "x = {}, y = {}, z = {} {} in J",
                in_model(at.r_ji_j.x),
                in_model(at.r_ji_j.y),
                in_model(at.r_ji_j.z),
                unit.name
            ))
            .help("turn J so that its x axis points at I, unless the beam is meant to start bent"),
        ));
    }
    if (distance - length).abs() > PRELOAD * length {
        let diagnostic = Diagnostic::warning(
            "beam/length",
            format!(
                "`length` of beam `{name}` is {} {}, but its markers are {} {} apart",
                in_model(length),
                unit.name,
                in_model(distance),
                unit.name
            ),
        );
        findings.push(
            Finding::new(diagnostic.help("if no preload is meant, give the distance of the markers as `length`"))
                .fixed_by(format!("force modify element_like beam beam_name={name} length={}", in_model(distance))),
        );
    }
    let angle = at.angles.iter().fold(0.0_f64, |largest, a| largest.max(a.abs()));
    if angle > SMALL_ANGLE {
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/axes",
                format!("the axes of I and J of beam `{name}` are {} degrees apart", number(angle.to_degrees())),
            )
            .note("a beam is unloaded when I has the axes of J, and describes angles up to about 10 degrees")
            .help(format!(
                "turn I so that its axes are those of J, or share the angle among {} beams",
                beams_for(angle)
            )),
        ));
    }
    if let Ok(law) = law(database, beam, false) {
        preload(database, beam, &law, at, findings);
    }
}

/// How many linear beams in a row share an angle so that none sees more than [`SMALL_ANGLE`].
fn beams_for(angle: f64) -> u32 {
    (angle / SMALL_ANGLE).ceil().max(1.0) as u32
}

/// The load at the start, if it is more than rounding.
fn preload(database: &Database, beam: ObjectId, law: &Law, at: &Placement, findings: &mut Vec<Finding>) {
    let [a, b, c] = at.angles;
    let q = [at.r_ji_j.x - law.length, at.r_ji_j.y, at.r_ji_j.z, a, b, c];
    let bent = q[1].abs().max(q[2].abs()) > PRELOAD * law.length || q[3..].iter().any(|angle| angle.abs() > 1e-6);
    if q[0].abs() <= PRELOAD * law.length && !bent {
        return;
    }
    let load: [f64; 6] = std::array::from_fn(|row| -(0..6).map(|n| law.stiffness[row][n] * q[n]).sum::<f64>());
    let units = database.units();
    let shown = |value: f64, dimension| number(value / units.factor(dimension));
    let forces: Vec<_> = load[..3].iter().map(|f| shown(*f, Dimension::FORCE)).collect();
    let torques: Vec<_> = load[3..].iter().map(|t| shown(*t, Dimension::TORQUE)).collect();
    let name = database.full_name(beam);
    findings.push(Finding::new(
        Diagnostic::warning("beam/preloaded", format!("beam `{name}` is loaded when the model is built"))
            .note(format!(
                "load on I in the axes of J: force {} {}, torque {} {}",
                forces.join(", "),
                units.label(Dimension::FORCE),
                torques.join(", "),
                units.label(Dimension::TORQUE)
            ))
            .help("place I at `length` along x of J with the axes of J if no preload is meant"),
    ));
}

/// Section data that cannot be, or hardly can be, what was meant.
fn data(database: &Database, beam: ObjectId, s: &Section, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    if let Err(troubles) = law(database, beam, false) {
        findings.extend(troubles.into_iter().map(Finding::new));
    }
    for (cell, ratio) in [("y_shear_area_ratio", s.asy), ("z_shear_area_ratio", s.asz)] {
        if ratio > 0.0 && ratio < 1.0 {
            findings.push(
                Finding::new(
                    Diagnostic::warning(
                        "beam/shear-ratio",
                        format!("`{cell}` of beam `{name}` is {}, which is not possible below 1", number(ratio)),
                    )
                    .note(
                        "it is the area over the shear area: 6/5 for a rectangle, 10/9 for a circle, 2 for a thin tube",
                    )
                    .help(format!("give the inverse, {}, or 0 for no shear deflection", number(1.0 / ratio))),
                )
                .fixed_by(format!("force modify element_like beam beam_name={name} {cell}={}", number(1.0 / ratio))),
            );
        }
    }
    let is_one = |cell: &str| {
        let given = database.number(beam, cell);
        given.is_none_or(|x| x == 1.0)
    };
    let cells = ["length", "area_of_cross_section", "youngs_modulus", "shear_modulus", "ixx", "iyy", "izz"];
    let ones: Vec<_> = cells.into_iter().filter(|cell| is_one(cell)).collect();
    if !ones.is_empty() {
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/default-of-one",
                format!("`{}` of beam `{name}` is 1, the default", ones.join("`, `")),
            )
            .note("a beam that is given no value gets 1 in the model's units")
            .help("give the value, or ignore this if 1 is meant"),
        ));
    }
    let polar = s.iyy + s.izz;
    // Saint-Venant's estimate for solid sections: within 10 percent for rectangles of any shape.
    let torsion = s.area.powi(4) / (40.0 * polar);
    if s.iyy > 0.0 && s.izz > 0.0 && s.iyy != s.izz && (s.ixx - polar).abs() < 1e-6 * polar {
        findings.push(Finding::new(
            Diagnostic::warning(
                "beam/polar-moment",
                format!("`ixx` of beam `{name}` is the polar moment iyy + izz of a section that is not round"),
            )
            .note("ixx is the torsion constant, which is smaller than the polar moment unless the section is round")
            .help(format!(
                "give the torsion constant of the section; Saint-Venant's estimate A^4 / (40 (iyy + izz)) for a solid one is {}",
                number(torsion / database.units().factor(Dimension::AREA_INERTIA))
            )),
        ));
    }
    let ratio = database.number(beam, "damping_ratio").unwrap_or(0.0);
    if ratio != 0.0 && database.value(beam, "matrix_of_damping_terms").is_some() {
        findings.push(
            Finding::new(
                Diagnostic::warning("beam/damping-twice", format!("the damping of beam `{name}` is given twice"))
                    .note("`matrix_of_damping_terms` is used and `damping_ratio` is not")
                    .help("set `damping_ratio` to 0, or modify the beam without the matrix"),
            )
            .fixed_by(format!("force modify element_like beam beam_name={name} damping_ratio=0")),
        );
    }
}
