//! Which class a statement makes, which words it knows beside those of the class, and how it is read
//! where the table of the class is not enough.

use super::{body, constraint, coupled, data, graphics, gravity, request, settings::is_setting, vector};
use text::Diagnostic;

use crate::read::{Builder, Entry, Form, Statement, Word};

/// What a statement makes.
pub(crate) enum Chosen {
    /// A class by its id; where there is none of that id, the first class of the statement.
    Class(&'static str),
    /// The statement does not say which of these it is.
    OneOf(Vec<&'static str>),
    /// A kind without a class.
    Unread(&'static str),
}

/// Arguments without which a statement means nothing.
pub(crate) const REQUIRED: &[(&str, &[&str])] = &[
    ("BEAM", &["I", "J", "LENGTH", "IXX", "IYY", "IZZ", "AREA", "EMODULUS", "GMODULUS"]),
    ("BUSHING", &["I", "J"]),
    ("FIELD", &["I", "J"]),
    ("SPRINGDAMPER", &["I", "J"]),
    ("SFORCE", &["I", "J", "FUNCTION"]),
    ("MOTION", &["FUNCTION"]),
    ("GCON", &["FUNCTION"]),
    ("VARIABLE", &["FUNCTION"]),
    ("DIFF", &["FUNCTION"]),
    ("SENSOR", &["FUNCTION"]),
    ("VFORCE", &["I", "JFLOAT"]),
    ("VTORQUE", &["I", "JFLOAT"]),
    ("GFORCE", &["I", "JFLOAT"]),
    ("JOINT", &["I", "J"]),
    ("JPRIM", &["I", "J"]),
    ("COUPLER", &["JOINTS"]),
    ("GEAR", &["JOINTS", "CV"]),
    ("CVCV", &["ICURVE", "JCURVE"]),
    ("NFORCE", &["I", "J"]),
    ("FRICTION", &["JOINT"]),
    ("LSE", &["X", "A"]),
    ("TFSISO", &["X", "U", "Y", "NUMERATOR", "DENOMINATOR"]),
    ("STRING", &["STRING"]),
    ("PTCV", &["I", "JFLOAT", "RM", "CURVE"]),
];

pub(crate) fn required(statement: &str, keyword: Option<&str>) -> bool {
    let list = REQUIRED.iter().find(|(name, _)| *name == statement);
    list.zip(keyword).is_some_and(|((_, keywords), keyword)| keywords.contains(&keyword))
}

const UNITS: &[Word] = &[
    ("FORCE", Form::Value),
    ("MASS", Form::Value),
    ("LENGTH", Form::Value),
    ("TIME", Form::Value),
    ("UCF", Form::Value),
    ("SYSTEM", Form::Value),
];
const TURNS: &[Word] = &[("TRANSLATIONAL", Form::Flag), ("ROTATIONAL", Form::Flag)];

/// Whether there may be several of a statement, told apart by numbers.
pub(crate) fn has_number(statement: &str) -> bool {
    !(is_setting(statement) || statement == "UNITS" || statement == "ACCGRAV")
}

/// The words a statement knows beside the keywords of its classes.
pub(crate) fn words(statement: &str) -> Vec<Word> {
    let kinds = |kinds: &[(&'static str, &'static str)]| kinds.iter().map(|(word, _)| (*word, Form::Flag)).collect();
    let words = match statement {
        "JOINT" => return [kinds(constraint::JOINTS), constraint::JOINT_VALUES.to_vec()].concat(),
        "JPRIM" => return kinds(constraint::PRIMITIVES),
        "ARRAY" => return kinds(data::ARRAYS),
        "CONTACT" => return coupled::contact_words(),
        "MOTION" => return constraint::motion_words(),
        "REQUEST" => return request::words(),
        "SENSOR" => return data::COMPARISONS.map(|word| (word, Form::Flag)).to_vec(),
        "UNITS" => UNITS,
        "PART" | "POINT_MASS" => body::BODY_WORDS,
        "MARKER" => body::MARKER_WORDS,
        "SFORCE" | "SPRINGDAMPER" => TURNS,
        "GRAPHICS" => graphics::WORDS,
        "VFORCE" | "VTORQUE" | "GFORCE" | "GSE" => vector::WORDS,
        "COUPLER" => coupled::COUPLER_WORDS,
        "PTCV" => coupled::POINT_CURVE_WORDS,
        "FIELD" => data::FIELD_WORDS,
        "MATRIX" => data::MATRIX_WORDS,
        "CURVE" => data::CURVE_WORDS,
        "SPLINE" => data::SPLINE_WORDS,
        _ => &[],
    };
    words.to_vec()
}

/// The class of the object a statement makes.
pub(crate) fn class_of(statement: &Statement) -> Chosen {
    match statement.name {
        "PART" => Chosen::Class(if statement.has("GROUND") { "ground" } else { "part" }),
        "MARKER" => Chosen::Class(if statement.has("FLOATING") { "floating_marker" } else { "marker" }),
        "JOINT" => constraint::kind(statement, constraint::JOINTS),
        "JPRIM" => constraint::kind(statement, constraint::PRIMITIVES),
        "SPRINGDAMPER" => {
            let turns = statement.has("ROTATIONAL");
            Chosen::Class(if turns { "rotational_spring_damper" } else { "translational_spring_damper" })
        }
        "GRAPHICS" => graphics::kind(statement),
        "ARRAY" => data::array_kind(statement),
        "MATRIX" => data::matrix_kind(statement),
        "REQUEST" => Chosen::Class("request"),
        _ => Chosen::Class(""),
    }
}

/// Reads what the table of the class does not tell.
pub(crate) fn read<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    match e.statement.name {
        "PART" | "POINT_MASS" => body::read_body(b, e),
        "MARKER" => body::read_marker(b, e),
        "JOINT" | "JPRIM" => constraint::read_joint(b, e),
        "MOTION" => constraint::read_motion(b, e),
        "SFORCE" => type_of_freedom(b, e),
        "SPRINGDAMPER" => {
            untold(b, e, &["TRANSLATIONAL", "ROTATIONAL"], "TRANSLATIONAL");
            e.flag("TRANSLATIONAL");
            e.flag("ROTATIONAL");
        }
        "GRAPHICS" => graphics::read(b, e),
        "REQUEST" => request::read(b, e),
        "VFORCE" | "VTORQUE" | "GFORCE" | "GSE" => vector::read(b, e),
        "COUPLER" => coupled::read_coupler(b, e),
        "PTCV" => coupled::read_point_curve(b, e),
        "CONTACT" => coupled::read_contact(b, e),
        "ACCGRAV" => gravity::read(b, e),
        "FIELD" => data::read_field(b, e),
        "ARRAY" => data::read_array(e),
        "MATRIX" => data::read_matrix(b, e),
        "CURVE" => data::read_curve(b, e),
        "SENSOR" => data::read_sensor(b, e),
        "SPLINE" => data::read_spline(b, e),
        _ => {}
    }
}

/// Says of a statement that leaves a choice open what is taken.
pub(super) fn untold(b: &mut Builder<'_>, e: &Entry<'_>, words: &[&str], taken: &str) {
    if !words.iter().any(|word| e.statement.has(word)) {
        let message = format!("{} does not say which of {} it is: taken is `{taken}`", e.name(), words.join(", "));
        b.report(Diagnostic::warning("dataset/kind-taken", message).at(e.statement.head, "not told").help("add it"));
    }
}

/// `TRANSLATIONAL` or `ROTATIONAL`, in a cell of its own.
fn type_of_freedom<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    untold(b, e, &["TRANSLATIONAL", "ROTATIONAL"], "TRANSLATIONAL");
    if let Some(word) = e.one_of(&["TRANSLATIONAL", "ROTATIONAL"]) {
        b.store(e.id, "type_of_freedom", model::Value::Text(word.to_ascii_lowercase()));
    }
}
