//! JOINT, JPRIM and MOTION: the kind is a word, start values depend on it.

use model::ObjectId;

use super::{function_or_user, number_field, numbers, reference, type_of_freedom};
use crate::{layout::Lines, write::Writer};

pub(super) fn joint(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let class = w.database.object(id).class;
    // `joint_revolute`, `jprim_parallel_axis`: the class names the kind behind the statement.
    let kind = class.id.split_once('_').map_or(class.id, |(_, kind)| kind);
    lines.flag(&match kind {
        "at_point" => "ATPOINT".to_string(),
        "parallel_axis" => "PARALLEL_AXES".to_string(),
        other => other.to_ascii_uppercase(),
    });
    reference(w, id, "i_marker_name", "I", lines);
    reference(w, id, "j_marker_name", "J", lines);
    number_field(w, id, "pitch", "PITCH", lines);
    number_field(w, id, "diameter_of_pitch", "PD", lines);
    let both = class.cell_index("translational_ic").is_some() && class.cell_index("rotational_ic").is_some();
    start(w, id, ["translational_ic", "velocity_ic"], if both { "ICTRAN" } else { "IC" }, lines);
    start(w, id, ["rotational_ic", "angular_velocity_ic"], if both { "ICROT" } else { "IC" }, lines);
    if w.database.text(id, "friction_enabled").is_some_and(|word| word != "no") {
        let name = w.database.full_name(id);
        w.warn("dataset/friction", format!("the friction of `{name}` is not written yet"));
    }
}

/// `IC = displacement, velocity`; what is not given is 0 where the other is.
fn start(w: &Writer<'_>, id: ObjectId, names: [&str; 2], keyword: &str, lines: &mut Lines) {
    let class = w.database.object(id).class;
    let value = |name: &str| numbers(w, id, class.field(class.cell_index(name)?))?.into_iter().next();
    let values = names.map(value);
    if values.iter().any(Option::is_some) {
        lines.list(keyword, &values.map(|v| v.unwrap_or_else(|| "0".to_string())));
    }
}

pub(super) fn motion(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    if w.database.reference(id, "joint_name").is_some() {
        type_of_freedom(w, id, lines);
        reference(w, id, "joint_name", "JOINT", lines);
    } else {
        reference(w, id, "i_marker_name", "I", lines);
        reference(w, id, "j_marker_name", "J", lines);
        if let Some(axis) = w.database.text(id, "axis") {
            lines.flag(&axis.to_ascii_uppercase());
        }
    }
    if let Some(order) = w.database.text(id, "time_derivative").filter(|word| *word != "displacement") {
        lines.flag(&order.to_ascii_uppercase());
    }
    for (name, keyword) in [
        ("displacement_ic", "ICDISP"),
        ("rotational_displacement_ic", "ICDISP"),
        ("velocity_ic", "ICVEL"),
        ("rotational_velocity_ic", "ICVEL"),
    ] {
        number_field(w, id, name, keyword, lines);
    }
    function_or_user(w, id, lines);
}
