//! PART, POINT_MASS and MARKER: places, masses, start velocities.

use model::{ObjectId, Value};

use super::{number_field, texts};
use crate::{
    layout::Lines,
    number::{number, turn},
    write::{Mass, Writer},
};

/// `QG = ...`, `REULER = ...`; what is zero is left out.
fn place(w: &Writer<'_>, id: ObjectId, position: &str, lines: &mut Lines) {
    let digits = w.options.digits;
    if let Some(r) = w.database.numbers(id, "location").filter(|r| r.iter().any(|x| *x != 0.0)) {
        lines.list(position, &r.iter().map(|x| number(*x, digits)).collect::<Vec<_>>());
    }
    if let Some(angles) = w.database.si_numbers(id, "orientation") {
        let angles: Vec<_> = angles.iter().map(|a| turn(a.to_degrees(), digits)).collect();
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
        let of = |name| w.database.number(id, name).unwrap_or(0.0);
        Mass {
            mass,
            center: w.database.reference(id, "center_of_mass_marker"),
            inertia_marker: w.database.reference(id, "inertia_marker"),
            inertia: [of("ixx"), of("iyy"), of("izz"), of("ixy"), of("izx"), of("iyz")],
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
