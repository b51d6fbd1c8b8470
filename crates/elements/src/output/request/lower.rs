//! A request becomes columns.

use model::ObjectId;
use schema::Dimension;
use text::Diagnostic;

use crate::{
    lower::Lowering,
    output::{
        outputs::{Column, Quantity},
        vector::{self, Markers, Vector},
    },
    runtime,
};

pub fn lower(lowering: &mut Lowering<'_>, request: ObjectId) {
    let database = lowering.database;
    let set = result_set(lowering, request);
    let functions: Vec<(usize, String)> = (1..=8)
        .map(|n| (n, runtime::text_of(database, request, &format!("f{n}"))))
        .filter(|(_, text)| !text.trim().is_empty())
        .collect();
    let given = lowering.columns.len();
    if let Some(kind) = database.text(request, "output_type") {
        of_markers(lowering, request, &set, &kind.to_ascii_lowercase());
    }
    for (n, text) in functions {
        if let Some(compiled) = runtime::compile(lowering, request, &text) {
            let unit = unit_of(lowering, request, n);
            let name = format!("{set}.{}", component_name(lowering, request, n));
            lowering.columns.push(Column::of_function(name, unit, compiled));
        }
    }
    let failed = lowering.diagnostics.iter().any(Diagnostic::is_error);
    if lowering.columns.len() == given && !failed {
        let name = lowering.name(request);
        lowering.report(
            Diagnostic::warning("request/nothing", format!("request `{name}` records nothing"))
                .note("subroutines and solver variables cannot be recorded yet")
                .help("give `output_type` with markers, or functions `f1` to `f8`"),
        );
    }
}

/// Name of the result set: as given, else the object's name.
fn result_set(lowering: &Lowering<'_>, request: ObjectId) -> String {
    let given = lowering.database.text(request, "results_name").filter(|name| !name.trim().is_empty());
    given.map_or_else(|| lowering.database.object(request).name.clone(), str::to_string)
}

fn texts<'a>(lowering: &Lowering<'a>, request: ObjectId, cell: &str) -> Vec<&'a str> {
    match lowering.database.value(request, cell) {
        Some(model::Value::Texts(texts)) => texts.iter().map(String::as_str).collect(),
        Some(model::Value::Text(text)) => vec![text],
        _ => Vec::new(),
    }
}

/// Name of the nth column: from the component names, else the titles, else `Fn`.
fn component_name(lowering: &Lowering<'_>, request: ObjectId, n: usize) -> String {
    let named = ["component_names", "title"].into_iter().find_map(|cell| {
        texts(lowering, request, cell).get(n - 1).map(|name| name.trim()).filter(|name| !name.is_empty())
    });
    named.map_or_else(|| format!("F{n}"), str::to_string)
}

/// Unit label of the nth column from `component_units`: a kind of quantity, or a label as it is.
fn unit_of(lowering: &Lowering<'_>, request: ObjectId, n: usize) -> String {
    texts(lowering, request, "component_units")
        .get(n - 1)
        .map_or(String::new(), |word| vector::label_of(lowering, word))
}

const TRANSLATION: [&str; 4] = ["X", "Y", "Z", "MAG"];
const ROTATION: [&str; 4] = ["R1", "R2", "R3", "RMAG"];

/// `X Y Z MAG R1 R2 R3 RMAG` of two markers.
fn of_markers(lowering: &mut Lowering<'_>, request: ObjectId, set: &str, kind: &str) {
    let Some(i) = lowering.frame_cell(request, "i_marker_name", "request/no-marker") else { return };
    let j = vector::optional_frame(lowering, request, "j_marker_name");
    let k = vector::optional_frame(lowering, request, "r_marker_name");
    let l = vector::optional_frame(lowering, request, "motion_rframe");
    let markers = Markers { i: i.0, j, k, l };
    let (first, second) = match kind {
        "displacement" => {
            vector::add_vector(lowering, set, &TRANSLATION, Vector::Displacement, markers);
            vector::add_angles(lowering, set, ["R1", "R2", "R3"], i.0, j);
            let turn = Quantity::Turn { i, j: j.map(equations::FrameId) };
            vector::add(lowering, format!("{set}.RMAG"), turn, Dimension::ANGLE);
            return;
        }
        "velocity" => (Vector::Velocity, Vector::AngularVelocity),
        "acceleration" => (Vector::Acceleration, Vector::AngularAcceleration),
        _ => (Vector::Force, Vector::Torque),
    };
    vector::add_vector(lowering, set, &TRANSLATION, first, markers);
    vector::add_vector(lowering, set, &ROTATION, second, markers);
}
