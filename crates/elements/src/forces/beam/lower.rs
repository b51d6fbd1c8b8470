//! A beam's cells become its section and its law, with the checks that need several values.

use model::{Database, ObjectId};
use schema::Dimension;
use text::Diagnostic;

use super::{
    corotational::Corotational,
    element::Beam,
    physics::{Angles, Formulation, Law, Mat6, Section, from_lower_triangle, proportional_damping, stiffness},
    schema::{DAMPING_MATRIX, DAMPING_RATIO},
};
use crate::{lower::Lowering, verify::modify};

pub fn lower(lowering: &mut Lowering<'_>, beam: ObjectId) {
    let i = lowering.frame_cell(beam, "i_marker_name", "beam/no-marker");
    let j = lowering.frame_cell(beam, "j_marker_name", "beam/no-marker");
    let law = law(lowering.database, beam, lowering.options.nonlinear_shear);
    let troubles = law.as_ref().err().into_iter().flatten().cloned();
    lowering.diagnostics.extend(troubles);
    let (Some(i), Some(j), Ok(law)) = (i, j, law) else { return };
    if !lowering.options.nonlinear_shear {
        say_what_is_ignored(lowering, beam);
    }
    let angles = lowering.options.beam_angles;
    let bodies = [lowering.body_of_frame(i), lowering.body_of_frame(j)];
    let force = Beam { name: lowering.name(beam), i, j, bodies, law: Law { angles, ..law } };
    lowering.add_force(beam, Box::new(force));
}

/// The beams that take part in a simulation, in order of creation.
pub fn active(database: &Database, model: ObjectId) -> Vec<ObjectId> {
    let mut active = crate::active_objects(database, model);
    active.retain(|&id| database.object(id).class == &super::CLASS);
    active
}

/// The markers I and J.
pub fn ends(database: &Database, beam: ObjectId) -> [Option<ObjectId>; 2] {
    ["i_marker_name", "j_marker_name"].map(|cell| database.reference(beam, cell))
}

/// The damping ratio, s. None where a damping matrix is given: its terms win over the ratio.
pub fn ratio_in_use(database: &Database, beam: ObjectId) -> Option<f64> {
    let ratio = || database.si(beam, DAMPING_RATIO).unwrap_or_else(|| default(database, beam, DAMPING_RATIO));
    database.value(beam, DAMPING_MATRIX).is_none().then(ratio)
}

/// Code of the note about ratios that are not used.
pub const SHEAR_IGNORED: &str = "beam/shear-ignored";

/// One note for all NONLINEAR beams with shear ratios, with the first of them.
fn say_what_is_ignored(lowering: &mut Lowering<'_>, beam: ObjectId) {
    let database = lowering.database;
    let ignored = |beam: ObjectId| {
        let nonlinear = database.text(beam, "formulation").is_some_and(|word| word.eq_ignore_ascii_case("nonlinear"));
        let given = |cell: &&str| database.number(beam, cell).is_some_and(|ratio| ratio != 0.0);
        ["y_shear_area_ratio", "z_shear_area_ratio"].into_iter().filter(given).find(|_| nonlinear)
    };
    let (Some(cell), false) = (ignored(beam), lowering.diagnostics.iter().any(|d| d.code == SHEAR_IGNORED)) else {
        return;
    };
    let count = active(database, lowering.model).into_iter().filter(|id| ignored(*id).is_some()).count();
    let rest = if count > 1 { format!(", and so are those of {} more", count - 1) } else { String::new() };
    let name = lowering.name(beam);
    lowering.diagnostics.push(
        Diagnostic::new(
            text::Severity::Note,
            SHEAR_IGNORED,
            format!("`{cell}` of the NONLINEAR beam `{name}` is not used{rest}"),
        )
        .note("NONLINEAR beams do not shear (Euler and Bernoulli)")
        .help("`--nonlinear-shear` of `flexure simulate`, `modes`, `beams`, `run` and `verify` lets them"),
    );
}

/// Section data in SI, unchecked; what is not given counts as the default the schema states.
pub fn section(database: &Database, beam: ObjectId) -> Section {
    let value = |name| database.si(beam, name).unwrap_or_else(|| default(database, beam, name));
    Section {
        length: value("length"),
        area: value("area_of_cross_section"),
        ixx: value("ixx"),
        iyy: value("iyy"),
        izz: value("izz"),
        e: value("youngs_modulus"),
        g: value("shear_modulus"),
        asy: value("y_shear_area_ratio"),
        asz: value("z_shear_area_ratio"),
    }
}

/// The schema's default of a cell, SI.
fn default(database: &Database, beam: ObjectId, name: &str) -> f64 {
    let class = database.object(beam).class;
    let field = class.fields().find(|f| f.name == name);
    match field.map(|f| (f.default, f.dimension)) {
        Some((schema::Default::Number(x), dimension)) => x * database.units().factor(dimension),
        _ => 0.0,
    }
}

/// The law of a beam, or everything that is wrong with its data. NONLINEAR beams have no shear
/// deflection (Euler and Bernoulli) unless it is asked for.
pub fn law(database: &Database, beam: ObjectId, nonlinear_shear: bool) -> Result<Law, Vec<Diagnostic>> {
    let section = section(database, beam);
    let mut troubles = Vec::new();
    troubles.extend(wrong_data(database, beam, &section).into_iter().map(|(_, error)| error));
    let stiffness = stiffness(&section);
    let damping = damping(database, beam, &mut troubles);
    let ratio = if let Damping::Proportional(ratio) = damping { ratio } else { 0.0 };
    let formulation = match database.text(beam, "formulation").unwrap_or("linear").to_ascii_lowercase().as_str() {
        "string" => Formulation::String,
        "nonlinear" => Formulation::Nonlinear(Corotational::new(&section, nonlinear_shear, ratio)),
        _ => Formulation::Linear,
    };
    let damping = match (damping, formulation) {
        (Damping::Matrix(matrix), _) => *matrix,
        (Damping::Proportional(_), Formulation::Nonlinear(_)) => [[0.0; 6]; 6],
        (Damping::Proportional(ratio), _) => proportional_damping(&stiffness, ratio),
    };
    if troubles.is_empty() {
        Ok(Law { length: section.length, stiffness, damping, formulation, angles: Angles::default() })
    } else {
        Err(troubles)
    }
}

/// Section data with which there is no beam: the cell and what is wrong with it.
pub fn wrong_data(database: &Database, beam: ObjectId, s: &Section) -> Vec<(&'static str, Diagnostic)> {
    let name = database.full_name(beam);
    let mut wrong = Vec::new();
    let mut must = |cell: &'static str, value: f64, positive: bool| {
        let bad = !value.is_finite() || value < 0.0 || (positive && value == 0.0);
        if !bad {
            return;
        }
        let shown = database.number(beam, cell).unwrap_or(value);
        let (code, wanted) = match (value.is_finite(), positive) {
            (false, _) => ("beam/not-a-number", "a finite number"),
            (true, true) => ("beam/not-positive", "above 0"),
            (true, false) => ("beam/negative", "0 or above"),
        };
        let error = Diagnostic::error(code, format!("`{cell}` of beam `{name}` is {shown}; it must be {wanted}"))
            .help(modify(database, beam, format_args!("{cell}=...")));
        wrong.push((cell, error));
    };
    must("length", s.length, true);
    must("area_of_cross_section", s.area, true);
    must("youngs_modulus", s.e, true);
    must("shear_modulus", s.g, true);
    must("ixx", s.ixx, false);
    must("iyy", s.iyy, false);
    must("izz", s.izz, false);
    must("y_shear_area_ratio", s.asy, false);
    must("z_shear_area_ratio", s.asz, false);
    if let Some(ratio) = ratio_in_use(database, beam) {
        must(DAMPING_RATIO, ratio, false);
    }
    wrong
}

/// How a beam is damped, SI.
enum Damping {
    /// This time multiplied by the stiffness.
    Proportional(f64),
    Matrix(Box<Mat6>),
}

/// The damping in SI.
fn damping(database: &Database, beam: ObjectId, troubles: &mut Vec<Diagnostic>) -> Damping {
    if let Some(ratio) = ratio_in_use(database, beam) {
        return Damping::Proportional(ratio);
    }
    let name = database.full_name(beam);
    let terms = database.numbers(beam, DAMPING_MATRIX).unwrap_or_default();
    let Ok(terms) = <[f64; 21]>::try_from(terms.as_slice()) else {
        troubles.push(
            Diagnostic::error(
                "beam/damping-terms",
                format!("beam `{name}` has {} damping terms; 21 numbers are wanted", terms.len()),
            )
            .note(
                "they are the lower triangle of a symmetric 6x6 matrix by columns: C11 C21 .. C61, C22 .. C62, .. C66",
            ),
        );
        return Damping::Proportional(0.0);
    };
    if terms.iter().any(|term| !term.is_finite()) {
        troubles.push(
            Diagnostic::error("beam/not-a-number", format!("a damping term of beam `{name}` is not a finite number"))
                .help("give 21 finite numbers"),
        );
    }
    Damping::Matrix(Box::new(damping_in_si(database, &terms)))
}

/// Terms are in force, length and time of the model and radians.
fn damping_in_si(database: &Database, terms: &[f64; 21]) -> Mat6 {
    let units = database.units();
    let per_velocity = units.factor(Dimension::DAMPING);
    let length = units.factor(Dimension::LENGTH);
    let mut matrix = from_lower_triangle(terms);
    for (row, values) in matrix.iter_mut().enumerate() {
        for (column, value) in values.iter_mut().enumerate() {
            let rotations = i32::from(row >= 3) + i32::from(column >= 3);
            *value *= per_velocity * length.powi(rotations);
        }
    }
    matrix
}
