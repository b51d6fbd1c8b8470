//! Where the two markers of a beam are, and the load that follows.

use std::fmt::Write;

use glam::{DQuat, DVec3};
use model::{CoordinateSystem, Database, ObjectId, Pose, Sequence};
use schema::Dimension;
use text::Diagnostic;

use super::exact;
use crate::forces::beam::{
    SMALL_ANGLE,
    lower::law,
    physics::{Angles, Law, Section},
};
use crate::verify::{Finding, modify, number};

/// Smallest distance from the axis, as a share of the length, that counts as off the axis.
const OFF_AXIS: f64 = 1e-3;
/// Smallest difference of length, as a share of it, that counts as a preload.
const PRELOAD: f64 = 1e-6;
/// Smallest angle that counts as a preload, rad: orientations are typed with six digits.
const TURNED: f64 = 1e-6;

/// I as seen from J, m.
pub(super) struct Placement {
    pub r_ji_j: DVec3,
    angles: [f64; 3],
    /// Whether J lies on +x of I, so that I and J may change places.
    swappable: bool,
    markers: [ObjectId; 2],
    i: String,
    j: String,
}

impl Placement {
    pub(super) fn of(database: &Database, i: ObjectId, j: ObjectId, angles: Angles) -> Placement {
        let (pose_i, pose_j) = (database.global_pose(i), database.global_pose(j));
        let seen: Pose = pose_j.inverse().then(&pose_i);
        let back = pose_i.inverse().then(&pose_j).origin;
        Placement {
            r_ji_j: seen.origin * database.units().factor(Dimension::LENGTH),
            angles: angles.of(&seen.rotation),
            swappable: back.x > 0.0 && back.y.hypot(back.z) <= back.x,
            markers: [i, j],
            i: database.full_name(i),
            j: database.full_name(j),
        }
    }
}

/// Where I lies in J, and what follows for the load at the start.
pub(super) fn find(database: &Database, beam: ObjectId, s: &Section, at: &Placement, findings: &mut Vec<Finding>) {
    let name = database.full_name(beam);
    let unit = database.units().length;
    let in_model = |metres: f64| number(metres / unit.si);
    let (length, distance) = (s.length, at.r_ji_j.length());
    let across = at.r_ji_j.y.hypot(at.r_ji_j.z);
    if distance < 1e-9 * length {
        findings.push(coincident(&name, &in_model(length), unit.name, at));
        return;
    }
    if at.r_ji_j.x < 0.0 && across <= at.r_ji_j.x.abs() {
        findings.push(swapped(database, beam, &in_model, length, at));
        return;
    }
    let first = findings.len();
    if across > OFF_AXIS * length {
        findings.push(off_axis(database, beam, &name, &in_model, at));
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
                .fixed_by(modify(database, beam, format_args!("length={}", exact(distance / unit.si)))),
        );
    }
    let angle = at.angles.iter().fold(0.0_f64, |largest, a| largest.max(a.abs()));
    if angle > SMALL_ANGLE {
        let finding = turned(database, beam, &name, angle, at, across > OFF_AXIS * length);
        findings.push(finding);
    }
    if let Ok(law) = law(database, beam, false) {
        let mended = findings[first..].iter().find(|f| f.fix.is_some()).map(|f| f.diagnostic.code);
        preload(database, beam, &law, at, mended, findings);
    }
}

fn coincident(name: &str, length: &str, unit: &str, at: &Placement) -> Finding {
    let Placement { i, j, .. } = at;
    Finding::new(
        Diagnostic::error("beam/coincident-markers", format!("the markers of beam `{name}` coincide"))
            .note(format!("I is `{i}`, J is `{j}`; undeformed, I lies at +{length} {unit} along x of J"))
            .note("no fix is offered: which marker is out of place, and where it belongs, is not in the model")
            .help("move one of the markers, or use a bushing for two points in one place"),
    )
}

fn swapped(
    database: &Database,
    beam: ObjectId,
    in_model: &dyn Fn(f64) -> String,
    length: f64,
    at: &Placement,
) -> Finding {
    let Placement { i, j, .. } = at;
    let (name, unit) = (database.full_name(beam), database.units().length.name);
    let diagnostic = Diagnostic::error(
        "beam/ends-swapped",
        format!("I and J of beam `{name}` are swapped: I lies on -x of J, at x = {} {unit}", in_model(at.r_ji_j.x)),
    )
    .note(format!("I is `{i}`, J is `{j}`; undeformed, I must lie at +{} {unit} along x of J", in_model(length)))
    .note(format!("as it is, the beam starts {} {unit} shorter than its free length", in_model(length - at.r_ji_j.x)));
    if at.swappable {
        Finding::new(diagnostic.help("exchange the I and the J marker")).fixed_by(modify(
            database,
            beam,
            format_args!("i_marker_name={j} j_marker_name={i}"),
        ))
    } else {
        Finding::new(
            diagnostic
                .note("no fix is offered: J does not lie on +x of I either, so that exchanging them does not help")
                .help("turn the axes of J, so that x points at I, and those of I likewise"),
        )
    }
}

fn off_axis(
    database: &Database,
    beam: ObjectId,
    name: &str,
    in_model: &dyn Fn(f64) -> String,
    at: &Placement,
) -> Finding {
    let r = at.r_ji_j;
    let degrees = r.y.hypot(r.z).atan2(r.x).to_degrees();
    let unit = database.units().length.name;
    let diagnostic = Diagnostic::warning(
        "beam/off-axis",
        format!("I of beam `{name}` lies {} degrees off the x axis of J", number(degrees)),
    )
    .note(format!("x = {}, y = {}, z = {} {unit} in J", in_model(r.x), in_model(r.y), in_model(r.z)))
    .help("turn J so that its x axis points at I, unless the beam is meant to start bent");
    straightened(database, beam, diagnostic, at)
}

/// Axes of I that are not those of J.
fn turned(
    database: &Database,
    beam: ObjectId,
    name: &str,
    angle: f64,
    at: &Placement,
    straightened_already: bool,
) -> Finding {
    let diagnostic = Diagnostic::warning(
        "beam/axes",
        format!("the axes of I and J of beam `{name}` are {} degrees apart", number(angle.to_degrees())),
    )
    .note("a beam is unloaded when I has the axes of J, and describes angles up to about 10 degrees")
    .help(format!("turn I so that its axes are those of J, or share the angle among {} beams", beams_for(angle)));
    if straightened_already {
        Finding::new(diagnostic.note("the fix of `beam/off-axis` turns both markers"))
    } else {
        straightened(database, beam, diagnostic, at)
    }
}

/// How many linear beams in a row share an angle so that none sees more than [`SMALL_ANGLE`].
fn beams_for(angle: f64) -> u32 {
    (angle / SMALL_ANGLE).ceil().max(1.0) as u32
}

/// A finding with the commands that give a beam two markers of its own in the same places, with x
/// along the line between them. The section is turned as little as may be. The old markers stay:
/// others may use them.
fn straightened(database: &Database, beam: ObjectId, diagnostic: Diagnostic, at: &Placement) -> Finding {
    let settings = database.settings();
    if settings.coordinate_system != CoordinateSystem::Cartesian || settings.sequence != Sequence::BODY_313 {
        let why = "no fix is offered: it would be read in the coordinate system and the rotation sequence in force";
        return Finding::new(diagnostic.note(why));
    }
    let [i, j] = at.markers;
    let (pose_i, pose_j) = (database.global_pose(i), database.global_pose(j));
    let chord = (pose_i.origin - pose_j.origin).normalize();
    let turn = DQuat::from_rotation_arc(pose_j.rotation.x_axis.normalize(), chord);
    let rotation = glam::DMat3::from_quat(turn) * pose_j.rotation;
    let mut commands = String::new();
    let mut names = Vec::new();
    for (marker, pose, end) in [(i, pose_i, "i"), (j, pose_j, "j")] {
        let Some(part) = database.object(marker).parent else { return Finding::new(diagnostic) };
        let part_name = database.full_name(part);
        let made = format!("{part_name}.{}", model::quoted(&format!("{}_{end}", database.object(beam).name)));
        if database.find(&made, "any").is_some() {
            return Finding::new(
                diagnostic.note(format!("no fix is offered: it would make a marker `{made}`, which exists")),
            );
        }
        let local = database.global_pose(part).inverse().then(&Pose { origin: pose.origin, rotation });
        let list = |v: [f64; 3]| v.map(exact).join(",");
        let angles = model::angles_of(&local.rotation).map(|a| a / database.units().angle.si);
        let _ = writeln!(
            commands,
            "marker create marker_name={made} location={} orientation={} relative_to={part_name}",
            list(local.origin.to_array()),
            list(angles)
        );
        names.push(made);
    }
    commands += &modify(database, beam, format_args!("i_marker_name={} j_marker_name={}", names[0], names[1]));
    Finding::new(diagnostic.note("the fix gives the beam two markers of its own in the same places, x from J to I"))
        .fixed_by(commands)
}

/// The load at the start, if it is more than rounding. `mended` is the code of a finding whose fix
/// takes it away.
fn preload(
    database: &Database,
    beam: ObjectId,
    law: &Law,
    at: &Placement,
    mended: Option<&str>,
    findings: &mut Vec<Finding>,
) {
    let [a, b, c] = at.angles;
    let q = [at.r_ji_j.x - law.length, at.r_ji_j.y, at.r_ji_j.z, a, b, c];
    let bent = q[1].abs().max(q[2].abs()) > PRELOAD * law.length || q[3..].iter().any(|angle| angle.abs() > TURNED);
    if q[0].abs() <= PRELOAD * law.length && !bent {
        return;
    }
    let load: [f64; 6] = std::array::from_fn(|row| -(0..6).map(|n| law.stiffness[row][n] * q[n]).sum::<f64>());
    let units = database.units();
    let shown = |value: f64, dimension| number(value / units.factor(dimension));
    let forces: Vec<_> = load[..3].iter().map(|f| shown(*f, Dimension::FORCE)).collect();
    let torques: Vec<_> = load[3..].iter().map(|t| shown(*t, Dimension::TORQUE)).collect();
    let name = database.full_name(beam);
    let diagnostic = Diagnostic::warning("beam/preloaded", format!("beam `{name}` is loaded when the model is built"))
        .note(format!(
            "load on I in the axes of J: force {} {}, torque {} {}",
            forces.join(", "),
            units.label(Dimension::FORCE),
            torques.join(", "),
            units.label(Dimension::TORQUE)
        ))
        .help("place I at `length` along x of J with the axes of J if no preload is meant");
    let why = match mended {
        Some(code) => format!("the fix of `{code}` takes the load away"),
        None => "no fix is offered: a beam of a curved structure starts bent so slightly on purpose".into(),
    };
    findings.push(Finding::new(diagnostic.note(why)));
}
