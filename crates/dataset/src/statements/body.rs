//! PART, POINT_MASS and MARKER: places, masses, start velocities.

use glam::{DMat3, DVec3};
use model::{Array, ObjectId, Value};
use text::Diagnostic;

use super::{number_field, texts};
use crate::{
    layout::Lines,
    number::{number, turn},
    read::{Builder, Entry, Form, Word},
    write::{Mass, Writer},
};

/// `QG = ...`, `REULER = ...`; what is zero is left out.
fn place(w: &Writer<'_>, id: ObjectId, position: &str, lines: &mut Lines) {
    let digits = w.options.digits;
    if let Some(r) = w.database.numbers(id, "location").filter(|r| r.iter().any(|x| *x != 0.0)) {
        lines.list(position, &r.iter().map(|x| number(*x, digits)).collect::<Vec<_>>());
    }
    if let Some(angles) = w.plain_numbers(id, "orientation") {
        let angles: Vec<_> = angles.iter().map(|a| turn(*a, digits)).collect();
        if angles.iter().any(|a| a != "0D") {
            lines.list("REULER", &angles);
        }
    }
}

pub(super) fn body(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    if w.database.object(id).class.id == "ground" {
        lines.flag("GROUND");
        return;
    }
    place(w, id, "QG", lines);
    for (name, keyword) in [("vx", "VX"), ("vy", "VY"), ("vz", "VZ")] {
        number_field(w, id, name, keyword, lines);
    }
    optional(w, id, w.database.reference(id, "vm"), "VM", lines);
    for (name, keyword) in [("wx", "WX"), ("wy", "WY"), ("wz", "WZ")] {
        number_field(w, id, name, keyword, lines);
    }
    optional(w, id, w.database.reference(id, "wm"), "WM", lines);
    exact(w, id, lines);
    mass(w, id, lines);
    if w.database.flag(id, "planar") == Some(true) {
        let name = w.database.full_name(id);
        w.warn("dataset/planar", format!("`{name}` moves in a plane only, which a dataset cannot say"));
    }
}

/// Start coordinates the assembly must keep.
fn exact(w: &Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let mut words = texts(w.database, id, "exact_coordinates");
    words.retain(|word| word != "none");
    if words.iter().any(|word| word == "all") {
        let all: &[&str] = &["x", "y", "z", "psi", "theta", "phi"];
        let count = if w.database.object(id).class.id == "point_mass" { 3 } else { 6 };
        words = all.iter().take(count).map(ToString::to_string).collect();
    }
    if !words.is_empty() {
        lines.argument("EXACT", &words.join(":").to_ascii_uppercase());
    }
}

/// A marker of a body; if it has no number, the body is written without the argument.
fn optional(w: &mut Writer<'_>, id: ObjectId, marker: Option<ObjectId>, keyword: &str, lines: &mut Lines) -> bool {
    let Some(marker) = marker else { return false };
    let (number, troubles) = w.attempt(|w| w.id_of(id, marker));
    let stands = troubles.is_empty();
    if stands {
        lines.argument(keyword, &number);
    }
    w.leave_out(&format!("{keyword} = {number}"), troubles);
    stands
}

/// Products of inertia below this part of the largest inertia come from rounding.
const ROUNDING: f64 = 1e-12;
/// The same where the inertia follows from shapes: axes that exports call principal are so to some
/// 1E-9 radians, and they write no products there.
const PRINCIPAL: f64 = 1e-9;

/// The marker called `cm`, which View takes if none is named.
fn marker_cm(w: &Writer<'_>, id: ObjectId) -> Option<ObjectId> {
    w.database.child(Some(id), "cm", "marker")
}

fn mass(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let given = w.database.number(id, "mass").map(|mass| {
        let of = |name: &&str| w.database.number(id, name).unwrap_or(0.0);
        Mass {
            mass,
            center: w.database.reference(id, "center_of_mass_marker"),
            inertia_marker: w.database.reference(id, "inertia_marker"),
            inertia: INERTIAS.each_ref().map(of),
        }
    });
    let rounding = if given.is_some() { ROUNDING } else { PRINCIPAL };
    let Some(mass) = given.or_else(|| w.options.mass.and_then(|of| of(w.database, id))) else {
        let name = w.database.full_name(id);
        w.warn("dataset/no-mass", format!("the mass of `{name}` is not given"));
        return;
    };
    let digits = w.options.digits;
    let mut at_centre = Lines::default();
    let center = mass.center.or_else(|| marker_cm(w, id));
    if !optional(w, id, center, "CM", &mut at_centre) && mass.mass != 0.0 {
        let name = w.database.full_name(id);
        let message = format!("the mass of `{name}`, which has no centre-of-mass marker: `MASS = {}`", mass.mass);
        w.warn("dataset/no-centre-of-mass", message);
        return;
    }
    lines.argument("MASS", &number(mass.mass, digits));
    lines.append(at_centre);
    optional(w, id, mass.inertia_marker, "IM", lines);
    let [moments @ .., xy, xz, yz] = mass.inertia;
    let largest = moments.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let [xy, xz, yz] = [xy, xz, yz].map(|x| if x.abs() < rounding * largest { 0.0 } else { x });
    if mass.inertia.iter().any(|x| *x != 0.0) {
        let mut values = moments.to_vec();
        if [xy, xz, yz] != [0.0; 3] {
            values.extend([xy, xz, yz]);
        }
        lines.list("IP", &values.iter().map(|x| number(*x, digits)).collect::<Vec<_>>());
    }
}

pub(super) fn marker(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let parent = w.database.object(id).parent;
    if let Some(body) = parent.filter(|p| w.database.object(*p).class.is("body")) {
        let number = w.id_of(id, body);
        let point_mass = w.database.object(body).class.statement == Some("POINT_MASS");
        lines.argument(if point_mass { "POINT_MASS" } else { "PART" }, &number);
    } else {
        let name = w.database.full_name(id);
        w.fail("dataset/marker-without-part", format!("the marker `{name}` belongs to no part"));
    }
    if w.database.object(id).class.id == "floating_marker" {
        lines.flag("FLOATING");
    }
    place(w, id, "QP", lines);
    for unwritten in ["node_id", "curve_name"] {
        if w.database.value(id, unwritten).is_some_and(|v| *v != Value::Nothing) {
            let name = w.database.full_name(id);
            w.warn("dataset/argument-not-written", format!("`{unwritten}` of `{name}` is not written yet"));
        }
    }
}

pub(super) const BODY_WORDS: &[Word] = &[
    ("GROUND", Form::Flag),
    ("EXACT", Form::Value),
    ("IP", Form::Value),
    ("XG", Form::Value),
    ("ZG", Form::Value),
    ("MATERIAL", Form::Value),
];
pub(super) const MARKER_WORDS: &[Word] = &[
    ("PART", Form::Value),
    ("POINT_MASS", Form::Value),
    ("FLEX_BODY", Form::Value),
    ("FE_PART", Form::Value),
    ("NODE_ID", Form::Value),
    ("NODE_LABEL", Form::Value),
    ("FLOATING", Form::Flag),
    ("XP", Form::Value),
    ("ZP", Form::Value),
    ("USEXP", Form::Flag),
    ("RM", Form::Value),
    ("CURVE", Form::Value),
    ("SURFACE", Form::Value),
    ("VELOCITY", Form::Value),
    ("VM", Form::Value),
];

/// Moments and products of inertia in the order of IP.
const INERTIAS: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "izx", "iyz"];

pub(super) fn read_body<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    if e.flag("GROUND") {
        // It is where it is.
        return;
    }
    read_place(b, e, ["QG", "XG", "ZG"], false);
    if let (Some(field), Some(argument)) = (Builder::field(e, "exact_coordinates"), e.take("EXACT")) {
        b.set_word(e, field, argument);
    }
    if let Some(argument) = e.take("IP")
        && let Some(values) = b.plain(argument)
    {
        if values.len() != 3 && values.len() != 6 {
            return b.count(argument, values.len(), "3 or 6");
        }
        for (name, x) in INERTIAS.iter().zip(values) {
            b.store(e.id, name, Value::Number(x));
        }
    }
}

pub(super) fn read_marker<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for keyword in ["PART", "POINT_MASS"] {
        e.take(keyword);
    }
    if !e.flag("FLOATING") {
        let along_x = e.flag("USEXP");
        read_place(b, e, ["QP", "XP", "ZP"], along_x);
    }
}

/// Location and orientation: nothing given is nothing shifted or turned. Two points may aim the axes
/// in place of angles: at the first one z, or x where `along_x`.
fn read_place<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>, [origin, x, z]: [&str; 3], along_x: bool) {
    let points = [x, z].map(|keyword| e.take(keyword));
    b.store(e.id, "location", Value::Array(Array::column(vec![0.0; 3])));
    b.store(e.id, "orientation", Value::Array(Array::column(vec![0.0; 3])));
    if points.iter().all(Option::is_none) {
        return;
    }
    let origin = e.statement.argument(origin).map_or(Some([0.0; 3]), |argument| b.exactly(argument));
    let [px, pz] = points.map(|argument| argument.and_then(|argument| b.exactly(argument)));
    let Some(origin) = origin.map(DVec3::from_array) else { return };
    let [to_x, to_z] = [px, pz].map(|point| point.map(|p: [f64; 3]| DVec3::from_array(p) - origin));
    let Some(axes) = aimed(to_x, to_z, along_x) else {
        let message = format!("`{x}` and `{z}` of {} give no direction", e.name());
        let at = points.into_iter().flatten().next().map_or(e.statement.head, |argument| argument.span);
        b.report(
            Diagnostic::error("dataset/no-direction", message)
                .at(at, "on the origin, or on one line with the other point")
                .help("give two points off the origin, or angles by `REULER`"),
        );
        return;
    };
    b.set_angles(e.id, "orientation", model::angles_of(&axes));
}

/// Axes from the directions to two points: one axis at its point, the other point in the half plane
/// where the other axis is positive. Without the second, the axis nearest to that of the body.
fn aimed(to_x: Option<DVec3>, to_z: Option<DVec3>, along_x: bool) -> Option<DMat3> {
    let apart = |aim: DVec3, other: Option<DVec3>, near: [DVec3; 2]| {
        let other = other.or_else(|| near.into_iter().find(|axis| aim.cross(*axis).length_squared() > 1e-12));
        other.filter(|other| aim.cross(*other).length_squared() > 0.0)
    };
    if along_x {
        let x = to_x?.try_normalize()?;
        let y = apart(x, to_z, [DVec3::Z, DVec3::Y])?.cross(x).try_normalize()?;
        return Some(DMat3::from_cols(x, y, x.cross(y)));
    }
    let z = to_z.unwrap_or(DVec3::Z).try_normalize()?;
    let y = z.cross(apart(z, to_x, [DVec3::X, DVec3::Y])?).try_normalize()?;
    Some(DMat3::from_cols(y.cross(z), y, z))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: by construction; the second point fixes the plane and its side.
    #[test]
    fn two_points_aim_the_axes() {
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z];
        assert_eq!(aimed(Some(x), Some(z), false), Some(DMat3::IDENTITY));
        assert_eq!(aimed(Some(x + 5.0 * z), Some(2.0 * z), false), Some(DMat3::IDENTITY));
        assert_eq!(aimed(Some(3.0 * x), Some(z - x), true), Some(DMat3::IDENTITY));
        assert_eq!(aimed(Some(y), Some(x), false), Some(DMat3::from_cols(y, z, x)));
        assert_eq!(aimed(None, Some(z), false), Some(DMat3::IDENTITY));
        assert_eq!(aimed(Some(z), Some(z), false), None);
        assert_eq!(aimed(None, Some(DVec3::ZERO), false), None);
    }
}
