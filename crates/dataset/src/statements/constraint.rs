//! JOINT, JPRIM and MOTION: the kind is a word, start values depend on it.

use model::{ObjectId, Value};
use text::Diagnostic;

use super::{Chosen, function_or_user, number_field, numbers, reference};
use crate::{
    layout::Lines,
    read::{Builder, Entry, Form, Statement, Word},
    write::Writer,
};

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
    let of_joint = w.database.reference(id, "joint_name").is_some();
    let words = |w: &Writer<'_>, lines: &mut Lines, cells: &[&str]| {
        for (cell, _) in MOTION_CELLS.iter().filter(|(cell, _)| cells.contains(cell)) {
            if let Some(word) = w.database.text(id, cell).filter(|word| *word != "displacement") {
                lines.flag(&word.to_ascii_uppercase());
            }
        }
    };
    if of_joint {
        words(w, lines, &["type_of_freedom"]);
        reference(w, id, "joint_name", "JOINT", lines);
    } else {
        reference(w, id, "i_marker_name", "I", lines);
        reference(w, id, "j_marker_name", "J", lines);
        words(w, lines, &["axis"]);
    }
    words(w, lines, &["time_derivative"]);
    for (keyword, cells) in MOTION_START {
        for cell in cells {
            number_field(w, id, cell, keyword, lines);
        }
    }
    function_or_user(w, id, lines);
}

/// Kinds of joints: the word of the statement and the class.
pub(super) const JOINTS: &[(&str, &str)] = &[
    ("REVOLUTE", "joint_revolute"),
    ("TRANSLATIONAL", "joint_translational"),
    ("CYLINDRICAL", "joint_cylindrical"),
    ("SPHERICAL", "joint_spherical"),
    ("PLANAR", "joint_planar"),
    ("FIXED", "joint_fixed"),
    ("UNIVERSAL", "joint_universal"),
    ("HOOKE", "joint_hooke"),
    ("CONVEL", "joint_convel"),
    ("SCREW", "joint_screw"),
    ("RACKPIN", "joint_rackpin"),
];
pub(super) const PRIMITIVES: &[(&str, &str)] = &[
    ("ATPOINT", "jprim_at_point"),
    ("INLINE", "jprim_inline"),
    ("INPLANE", "jprim_inplane"),
    ("ORIENTATION", "jprim_orientation"),
    ("PARALLEL_AXES", "jprim_parallel_axis"),
    ("PERPENDICULAR", "jprim_perpendicular"),
];
/// What a JOINT takes beside its kind.
pub(super) const JOINT_VALUES: &[Word] = &[
    ("PITCH", Form::Value),
    ("PD", Form::Value),
    ("IC", Form::Value),
    ("ICROT", Form::Value),
    ("ICTRAN", Form::Value),
];
/// Cells of a MOTION that are bare words of the statement.
pub(super) const MOTION_CELLS: [(&str, &[&str]); 3] = [
    ("type_of_freedom", &["TRANSLATIONAL", "ROTATIONAL"]),
    ("axis", &["X", "Y", "Z", "B1", "B2", "B3"]),
    ("time_derivative", &["DISPLACEMENT", "VELOCITY", "ACCELERATION"]),
];
/// Its start values: the cells of what slides and of what turns.
const MOTION_START: [(&str, [&str; 2]); 2] = [
    ("ICDISP", ["displacement_ic", "rotational_displacement_ic"]),
    ("ICVEL", ["velocity_ic", "rotational_velocity_ic"]),
];

pub(super) fn motion_words() -> Vec<Word> {
    let flags = MOTION_CELLS.iter().flat_map(|(_, words)| words.iter().map(|word| (*word, Form::Flag)));
    flags.chain(MOTION_START.map(|(keyword, _)| (keyword, Form::Value))).collect()
}

/// The class that the word of a statement stands for.
pub(super) fn kind(statement: &Statement, kinds: &[(&'static str, &'static str)]) -> Chosen {
    match kinds.iter().find(|(word, _)| statement.has(word)) {
        Some((_, class)) => Chosen::Class(class),
        None => Chosen::OneOf(kinds.iter().map(|(word, _)| *word).collect()),
    }
}

pub(super) fn read_joint<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    if let Some((word, _)) = JOINTS.iter().chain(PRIMITIVES).find(|(_, class)| *class == e.class.id) {
        e.flag(word);
    }
    for (keyword, cell) in [("PITCH", "pitch"), ("PD", "diameter_of_pitch")] {
        if e.class.cell_index(cell).is_some()
            && let Some(argument) = e.take(keyword)
        {
            b.set_numbers(e, cell, argument);
        }
    }
    let slides = e.class.cell_index("translational_ic").is_some();
    let turns = e.class.cell_index("rotational_ic").is_some();
    for (keyword, cells, here) in [
        ("ICTRAN", ["translational_ic", "velocity_ic"], slides),
        ("ICROT", ["rotational_ic", "angular_velocity_ic"], turns),
        ("IC", ["translational_ic", "velocity_ic"], slides && !turns),
        ("IC", ["rotational_ic", "angular_velocity_ic"], turns && !slides),
    ] {
        if here && let Some(argument) = e.take(keyword) {
            let Some(list) = b.list(argument) else { continue };
            if list.is_empty() || list.len() > 2 {
                b.count(argument, list.len(), "1 or 2");
                continue;
            }
            for (cell, one) in cells.into_iter().zip(&list) {
                b.set_listed(e, cell, argument, std::slice::from_ref(one));
            }
        }
    }
}

pub(super) fn read_motion<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for (cell, words) in MOTION_CELLS {
        if let Some(word) = e.one_of(words) {
            b.store(e.id, cell, Value::Text(word.to_ascii_lowercase()));
        }
    }
    let driven = ["JOINT", "I"].iter().any(|keyword| e.statement.argument(keyword).is_some());
    if !driven {
        let message = format!("{} drives nothing", e.name());
        let nothing =
            Diagnostic::error("dataset/missing-argument", message).at(e.statement.head, "no joint, no markers");
        b.report(nothing.help("add `JOINT = ...`, or `I = ..., J = ...` and the axis"));
    } else if e.statement.argument("JOINT").is_none() {
        b.needs(e, "J");
        if b.database.text(e.id, "axis").is_none() {
            let [_, (_, axes), _] = MOTION_CELLS;
            let message = format!("{} does not say which axis it drives", e.name());
            let open = Diagnostic::error("dataset/no-kind", message).at(e.statement.head, "no axis");
            b.report(open.help(format!("it is one of {}", axes.join(", "))));
        }
    }
    // Whether the start values are lengths or angles follows from what is driven.
    let text = |b: &Builder<'_>, cell| b.database.text(e.id, cell).map(str::to_string);
    let turns = text(b, "type_of_freedom")
        .map_or_else(|| text(b, "axis").is_some_and(|axis| axis.starts_with('b')), |word| word == "rotational");
    for (keyword, [slides, turned]) in MOTION_START {
        if let Some(argument) = e.take(keyword) {
            b.set_numbers(e, if turns { turned } else { slides }, argument);
        }
    }
}
