//! Words of a statement of which one excludes others: `IMPACT` and `POISSON` of a CONTACT.

use super::{constraint, data, graphics, request};

/// Arguments that go together; the first one is what the alternative is known by.
type Set = &'static [&'static str];

const TURNS: &[Set] = &[&["TRANSLATIONAL"], &["ROTATIONAL"]];
const AXES_OF_PART: &[Set] = &[&["REULER"], &["XG", "ZG"]];

/// The choices of statements: of each list, the arguments of one set stand.
const CHOICES: &[(&str, &[Set])] = &[
    ("PART", AXES_OF_PART),
    ("POINT_MASS", AXES_OF_PART),
    ("MARKER", &[&["PART"], &["POINT_MASS"], &["FLEX_BODY"], &["FE_PART"]]),
    ("MARKER", &[&["REULER"], &["XP", "ZP", "USEXP"]]),
    ("MOTION", &[&["JOINT", "TRANSLATIONAL", "ROTATIONAL"], &["I", "J", "X", "Y", "Z", "B1", "B2", "B3"]]),
    ("MOTION", TURNS),
    ("SFORCE", TURNS),
    (
        "SPRINGDAMPER",
        &[&["TRANSLATIONAL", "K", "C", "LENGTH", "FORCE"], &["ROTATIONAL", "KT", "CT", "ANGLE", "TORQUE"]],
    ),
    ("VFORCE", &[&["FX", "FY", "FZ"], &["FUNCTION"]]),
    ("VTORQUE", &[&["TX", "TY", "TZ"], &["FUNCTION"]]),
    ("GFORCE", &[&["FX", "FY", "FZ", "TX", "TY", "TZ"], &["FUNCTION"]]),
    (
        "CONTACT",
        &[
            &["IMPACT", "STIFFNESS", "DAMPING", "DMAX", "EXPONENT"],
            &["POISSON", "PENALTY", "RESTITUTION_COEFFICIENT"],
            &["NORMAL_FUNCTION"],
        ],
    ),
    ("COUPLER", &[&["SCALES"], &["FUNCTION"]]),
    ("MATRIX", &[&["FULL", "VALUES"], &["SPARSE", "ENTRIES"], &["FILE", "NAME"]]),
    ("CURVE", &[&["MATRIX", "CURVE_POINTS", "CONTROL_POINTS"], &["FUNCTION"]]),
    ("CURVE", &[&["CURVE_POINTS"], &["CONTROL_POINTS"]]),
    ("CURVE", &[&["OPEN"], &["CLOSED"]]),
    ("SPLINE", &[&["X", "Y"], &["FILE", "BLOCK", "CHANNEL"], &["FUNCTION"]]),
];

/// Bare words of a statement of which there is one.
fn words(statement: &str) -> Vec<Vec<&'static str>> {
    let first = |kinds: &[(&'static str, &'static str)]| kinds.iter().map(|(word, _)| *word).collect();
    match statement {
        "JOINT" => vec![first(constraint::JOINTS)],
        "JPRIM" => vec![first(constraint::PRIMITIVES)],
        "ARRAY" => vec![first(data::ARRAYS)],
        "MOTION" => constraint::MOTION_CELLS.iter().skip(1).map(|(_, words)| words.to_vec()).collect(),
        "SENSOR" => vec![data::COMPARISONS.to_vec()],
        "REQUEST" => vec![request::KINDS.to_vec()],
        "GRAPHICS" => vec![graphics::shapes()],
        _ => Vec::new(),
    }
}

/// Sets of arguments of which one stands.
pub(crate) type Choice = Vec<Vec<&'static str>>;

/// The choices of a statement.
pub(crate) fn choices(statement: &str) -> Vec<Choice> {
    let sets = CHOICES.iter().filter(|(name, _)| *name == statement);
    let sets = sets.map(|(_, sets)| sets.iter().map(|set| set.to_vec()).collect());
    let words = words(statement).into_iter().map(|words| words.into_iter().map(|word| vec![word]).collect());
    sets.chain(words).collect()
}
