//! COUPLER, PTCV, CONTACT and DIFF: statements whose words do not follow from the schema alone.

use model::{Array, ObjectId, Value};
use schema::Kind;
use text::Diagnostic;

use super::{function_or_user, number_field, numbers, reference, texts};
use crate::{
    layout::Lines,
    read::{Argument, Builder, Entry, Form, Word},
    write::Writer,
};

/// Fails for each cell that is set and that the statement has no known word for.
pub(super) fn refuse(w: &mut Writer<'_>, id: ObjectId, cells: &[&str]) {
    for cell in cells {
        let set = match w.database.value(id, cell) {
            None | Some(Value::Nothing | Value::Flag(false)) => false,
            Some(Value::Text(text)) => !text.is_empty(),
            Some(_) => true,
        };
        if set {
            let name = w.database.full_name(id);
            w.fail("dataset/argument-not-written", format!("`{cell}` of `{name}` is not written yet"));
        }
    }
}

/// `, IGEOM = 1, 2` from the objects of a cell.
fn references(w: &mut Writer<'_>, id: ObjectId, cell: &str, keyword: &str, lines: &mut Lines) {
    let objects = w.database.value(id, cell).map(Value::objects).unwrap_or_default();
    if !objects.is_empty() {
        let ids: Vec<_> = objects.iter().map(|o| w.id_of(id, *o)).collect();
        lines.list(keyword, &ids);
    }
}

pub(super) fn coupler(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let name = w.database.full_name(id);
    references(w, id, "joint_name", "JOINTS", lines);
    refuse(w, id, &["user_function", "routine"]);
    let word = w.database.text(id, "type_of_freedom").map(str::to_string);
    let kinds: Vec<String> = match word {
        Some(word) => word.split('_').map(str::to_string).collect(),
        None => texts(w.database, id, "freedom_type"),
    };
    let letters: Vec<_> =
        kinds.iter().filter_map(|k| k.chars().next()).map(|c| c.to_ascii_uppercase().to_string()).collect();
    if letters.is_empty() {
        w.fail("dataset/no-freedom", format!("`{name}` does not say which freedoms it couples"));
    }
    lines.argument("TYPE", &letters.join(":"));
    if w.database.numbers(id, "motion_multipliers").is_none() {
        w.fail("dataset/no-scales", format!("`{name}` has no motion_multipliers"));
    }
    number_field(w, id, "motion_multipliers", "SCALES", lines);
}

pub(super) fn point_curve(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    for (cell, keyword) in [
        ("i_marker_name", "I"),
        ("j_floating_marker_name", "JFLOAT"),
        ("ref_marker_name", "RM"),
        ("curve_name", "CURVE"),
    ] {
        if w.database.reference(id, cell).is_none() {
            let name = w.database.full_name(id);
            w.fail("dataset/no-marker", format!("`{name}` has no `{cell}`"));
        }
        reference(w, id, cell, keyword, lines);
    }
    refuse(w, id, &["displacement_ic", "velocity_ic", "ic_ref_marker_name"]);
}

pub(super) fn curve_curve(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    super::regular::arguments(w, id, lines);
    refuse(w, id, &["i_displacement_ic", "j_displacement_ic", "i_velocity_ic", "j_velocity_ic"]);
    refuse(w, id, &["i_ic_ref_marker_name", "j_ic_ref_marker_name"]);
}

pub(super) fn contact(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let kinds = texts(w.database, id, "type");
    if let [kind] = kinds.as_slice() {
        lines.argument("TYPE", &kind.to_ascii_uppercase());
    }
    references(w, id, "i_geometry_name", "IGEOM", lines);
    references(w, id, "j_geometry_name", "JGEOM", lines);
    let impact = w.database.number(id, "stiffness").is_some();
    let poisson = w.database.number(id, "penalty").is_some();
    if impact == poisson {
        let name = w.database.full_name(id);
        w.fail("dataset/no-law", format!("`{name}` has no stiffness and no penalty"));
    }
    lines.flag(CONTACT_LAWS[usize::from(!impact)]);
    for (cell, keyword) in CONTACT_LAW {
        number_field(w, id, cell, keyword, lines);
    }
    if let Some(word) = w.database.text(id, "coulomb_friction").filter(|word| *word != "off") {
        lines.argument("COULOMB_FRICTION", &word.to_ascii_uppercase());
        for (cell, keyword) in CONTACT_FRICTION {
            number_field(w, id, cell, keyword, lines);
        }
    }
    refuse(
        w,
        id,
        &[
            "i_marker_name",
            "i_flex",
            "i_edge",
            "i_edge_index",
            "j_flex",
            "j_edge",
            "j_edge_index",
            "i_flip_normal",
            "j_flip_normal",
            "i_flip_geometry_name",
            "j_flip_geometry_name",
            "geometry_routines",
            "normal_function",
            "normal_routine",
            "augmented_lagrangian_formulation",
            "stiction",
            "max_stiction_deformation",
            "friction_function",
            "friction_routine",
            "face_contact_top",
            "face_contact_bottom",
        ],
    );
}

pub(super) fn differential_equation(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let field = w.database.object(id).class.cell_index("initial_condition");
    let field = field.map(|index| *w.database.object(id).class.field(index));
    if let Some(values) = field.and_then(|f| numbers(w, id, &f)) {
        lines.list("IC", &values);
    }
    for (cell, keyword) in [("implicit", "IMPLICIT"), ("static_hold", "STATIC_HOLD")] {
        if w.database.flag(id, cell) == Some(true) {
            lines.flag(keyword);
        }
    }
    refuse(w, id, &["dynamic_hold"]);
    function_or_user(w, id, lines);
}

pub(super) const COUPLER_WORDS: &[Word] = &[("TYPE", Form::Value), ("FUNCTION", Form::Function)];
pub(super) const POINT_CURVE_WORDS: &[Word] = &[
    ("DISPLACEMENT", Form::Value),
    ("VELOCITY", Form::Value),
    ("ICRM", Form::Value),
    ("INTERPOLATION_TOLERANCE", Form::Value),
];
/// What a CONTACT is between, by cell and keyword.
const CONTACT_ENDS: [(&str, &str); 3] = [("type", "TYPE"), ("i_geometry_name", "IGEOM"), ("j_geometry_name", "JGEOM")];
/// How its normal force follows from the depth.
const CONTACT_LAWS: [&str; 2] = ["IMPACT", "POISSON"];
const CONTACT_LAW: [(&str, &str); 6] = [
    ("stiffness", "STIFFNESS"),
    ("damping", "DAMPING"),
    ("dmax", "DMAX"),
    ("exponent", "EXPONENT"),
    ("penalty", "PENALTY"),
    ("restitution_coefficient", "RESTITUTION_COEFFICIENT"),
];
/// Numbers of its friction, where that is not off.
const CONTACT_FRICTION: [(&str, &str); 4] = [
    ("mu_static", "MU_STATIC"),
    ("mu_dynamic", "MU_DYNAMIC"),
    ("stiction_transition_velocity", "STICTION_TRANSITION_VELOCITY"),
    ("friction_transition_velocity", "FRICTION_TRANSITION_VELOCITY"),
];

/// Cells of a CONTACT that are read as they stand, with their keywords.
fn contact_cells() -> impl Iterator<Item = (&'static str, &'static str)> {
    let friction = std::iter::once(("coulomb_friction", "COULOMB_FRICTION"));
    CONTACT_ENDS.into_iter().chain(CONTACT_LAW).chain(friction).chain(CONTACT_FRICTION)
}

pub(super) fn contact_words() -> Vec<Word> {
    let laws = CONTACT_LAWS.into_iter().map(|law| (law, Form::Flag));
    let values = contact_cells().map(|(_, keyword)| (keyword, Form::Value));
    laws.chain(values).chain([("NORMAL_FUNCTION", Form::Function)]).collect()
}

pub(super) fn read_coupler<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let joints = e.statement.argument("JOINTS").map_or(0, |argument| argument.items(b.text).len());
    // Another number of joints is told of the joints.
    let joints = if (2..=3).contains(&joints) { joints } else { 0 };
    if let Some(argument) = e.take("TYPE") {
        read_freedoms(b, e, argument, joints);
    }
    if let Some(argument) = e.take("SCALES") {
        read_scales(b, e, argument, joints);
    } else if e.statement.argument("FUNCTION").is_none() {
        b.needs(e, "SCALES");
    }
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
}

/// Whether each joint turns or slides.
fn read_freedoms(b: &mut Builder<'_>, e: &Entry<'_>, argument: &Argument, joints: usize) {
    let mut kinds = Vec::new();
    for (word, at) in argument.words(b.text) {
        let typed = word.to_ascii_uppercase();
        let begins = |freedom: &str| !typed.is_empty() && freedom.starts_with(&typed);
        kinds.push(match [begins("ROTATIONAL"), begins("TRANSLATIONAL")] {
            [true, _] => "rot",
            [_, true] => "tra",
            _ => return b.unknown_word(argument, (word, at), &["R", "T"]),
        });
    }
    if joints > 0 && kinds.len() != joints {
        return b.count(argument, kinds.len(), &format!("{joints}, one for each joint,"));
    }
    b.store(e.id, "type_of_freedom", Value::Text(kinds.join("_")));
}

/// One factor less than joints: the first joint has 1.
fn read_scales(b: &mut Builder<'_>, e: &Entry<'_>, argument: &Argument, joints: usize) {
    let Some(mut scales) = b.plain(argument) else { return };
    if scales.len() + 1 == joints {
        scales.insert(0, 1.0);
    }
    if joints > 0 && scales.len() != joints {
        return b.count(argument, scales.len(), &format!("{} or {joints}", joints - 1));
    }
    b.store(e.id, "motion_multipliers", Value::Array(Array::column(scales)));
}

pub(super) fn read_point_curve<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for (keyword, cell) in [("DISPLACEMENT", "displacement_ic"), ("VELOCITY", "velocity_ic")] {
        if let Some(argument) = e.take(keyword) {
            b.set_numbers(e, cell, argument);
        }
    }
}

pub(super) fn read_contact<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let law = e.one_of(&CONTACT_LAWS);
    match law {
        Some("IMPACT") => b.needs(e, "STIFFNESS"),
        Some(_) => b.needs(e, "PENALTY"),
        None if e.statement.argument("NORMAL_FUNCTION").is_none() => {
            let message = format!("{} does not say what its normal force follows from", e.name());
            let laws = format!("add one of {}, NORMAL_FUNCTION", CONTACT_LAWS.join(", "));
            b.report(Diagnostic::error("dataset/no-kind", message).at(e.statement.head, "no law of force").help(laws));
        }
        None => {}
    }
    for (cell, keyword) in contact_cells() {
        let Some(field) = Builder::field(e, cell) else { continue };
        let Some(argument) = e.take(keyword) else { continue };
        match field.kind {
            Kind::Object(..) => b.set_objects(e, field, argument),
            Kind::Choice(_) => b.set_word(e, field, argument),
            Kind::Text => b.set_text(e, field, argument),
            _ => b.set_numbers(e, cell, argument),
        }
    }
    if e.statement.argument("COULOMB_FRICTION").is_none() {
        b.store(e.id, "coulomb_friction", Value::Text("off".to_string()));
    }
}
