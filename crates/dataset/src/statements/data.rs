//! FIELD, GSE, SENSOR and the data elements whose words do not follow from the schema alone: ARRAY,
//! MATRIX, CURVE, SPLINE.

use model::{Array, ObjectId, Value};
use text::Diagnostic;

use super::{Chosen, coupled::refuse, function_text, number_field, numbers, regular, user_function};
use crate::{
    layout::Lines,
    number,
    read::{Argument, Builder, Entry, Form, Statement, Word, parse},
    write::Writer,
};

/// `, FUNCTION = USER(...)` and its routine, for classes without another function.
fn subroutine(w: &Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let Some(call) = user_function(w, id) else { return };
    lines.function("FUNCTION", &call);
    if let Some(routine) = w.database.text(id, "routine").filter(|r| !r.is_empty()) {
        lines.end_function();
        lines.argument("ROUTINE", routine);
    }
}

/// The values of two cells of three as one argument of six, unless all are zero.
fn six(w: &Writer<'_>, id: ObjectId, keyword: &str, cells: [&str; 2], lines: &mut Lines) {
    let class = w.database.object(id).class;
    let values = cells.map(|cell| {
        let field = class.cell_index(cell).map(|index| class.field(index));
        field.and_then(|field| numbers(w, id, field)).unwrap_or_else(|| vec!["0".to_string(); 3])
    });
    let values = values.concat();
    if values.iter().any(|x| x != "0" && x != "0D") {
        lines.list(keyword, &values);
    }
}

pub(super) fn field(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    regular::without(w, id, &["ROUTINE"], lines);
    for (keyword, cells) in FIELD_SIX {
        six(w, id, keyword, cells, lines);
    }
    subroutine(w, id, lines);
}

pub(super) fn general_equation(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    regular::without(w, id, &["ROUTINE", "INTERFACE"], lines);
    refuse(w, id, &["user_sample_period", "sample_routine", "sample_offset", "discrete", "implicit", "statics_only"]);
    refuse(w, id, &["df_dx_method", "df_du_method", "dg_dx_method", "dg_du_method"]);
    subroutine(w, id, lines);
    let routines = super::texts(w.database, id, "interface_routines");
    if !routines.is_empty() {
        if user_function(w, id).is_some() && w.database.text(id, "routine").is_none_or(str::is_empty) {
            lines.end_function();
        }
        lines.list("INTERFACE", &routines);
    }
}

pub(super) fn array(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let class = w.database.object(id).class.id;
    if let Some((word, _)) = ARRAYS.iter().find(|(_, kind)| *kind == class) {
        lines.flag(word);
    }
    regular::arguments(w, id, lines);
}

pub(super) fn matrix(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    match w.database.object(id).class.id {
        "matrix_full" => {
            let rows = w.database.text(id, "input_order") == Some("by_row");
            lines.argument("FULL", if rows { "RORDER" } else { "CORDER" });
            refuse(w, id, &["result_set_component_names"]);
        }
        "matrix_sparse" => {
            lines.flag("SPARSE");
            let columns = ["row_index", "column_index", "values"].map(|cell| w.database.numbers(id, cell));
            let [Some(rows), Some(columns), Some(values)] = columns else { return };
            let written = |x: &f64| number(*x, w.options.digits);
            let entries = rows.iter().zip(&columns).zip(&values).map(|((r, c), v)| [r, c, v].map(written));
            lines.list("ENTRIES", &entries.flatten().collect::<Vec<_>>());
            return;
        }
        _ => {}
    }
    regular::arguments(w, id, lines);
}

pub(super) fn curve(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    if w.database.flag(id, "closed") != Some(true) {
        lines.flag("OPEN");
    }
    regular::without(w, id, &["ROUTINE"], lines);
    if w.database.text(id, "fit_type") == Some("curve_points") && w.database.reference(id, "matrix_name").is_some() {
        lines.flag("CURVE_POINTS");
    }
    number_field(w, id, "interpolation_order", "ORDER", lines);
    refuse(w, id, &["tension"]);
    subroutine(w, id, lines);
}

pub(super) fn spline(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    refuse(w, id, &["x_result_set_component_name", "y_result_set_component_name", "z_result_set_component_name"]);
    let second = w.database.numbers(id, "z").unwrap_or_default();
    let rows = second.len();
    if rows == 0 {
        return regular::arguments(w, id, lines);
    }
    regular::without(w, id, &["Y", "LINEAR_EXTRAPOLATE"], lines);
    let values = w.database.numbers(id, "y").unwrap_or_default();
    let width = values.len() / rows;
    if width * rows != values.len() || width == 0 {
        let name = w.database.full_name(id);
        w.fail("dataset/uneven-surface", format!("`{name}` has {} values for {rows} rows", values.len()));
        return;
    }
    for (z, row) in second.iter().zip(values.chunks(width)) {
        let row: Vec<_> = std::iter::once(z).chain(row).map(|x| number(*x, w.options.digits)).collect();
        lines.list("Y", &row);
    }
    if w.database.flag(id, "linear_extrapolate") == Some(true) {
        lines.flag("LINEAR_EXTRAPOLATE");
    }
}

pub(super) fn sensor(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    for (keyword, plain, angular) in SENSOR_LIMITS {
        let cell = if w.database.value(id, angular).is_some() { angular } else { plain };
        number_field(w, id, cell, keyword, lines);
    }
    lines.flag(&w.database.text(id, "compare").unwrap_or("eq").to_ascii_uppercase());
    refuse(w, id, &["bisection", "time_error", "user_evaluate", "evaluate_routine"]);
    regular::without(w, id, &["VALUE", "ERROR", "FUNCTION", "ROUTINE", "EVALUATE"], lines);
    super::function_or_user(w, id, lines);
    let evaluate = function_text(w, id, "evaluate");
    if !evaluate.is_empty() {
        lines.end_function();
        lines.function("EVALUATE", &evaluate);
    }
}

/// Kinds of arrays: the word of the statement and the class.
pub(super) const ARRAYS: &[(&str, &str)] = &[("X", "array_x"), ("U", "array_u"), ("Y", "array_y"), ("IC", "array_ic")];
/// Limits of a sensor: of a plain function, and of one that is an angle.
const SENSOR_LIMITS: [(&str, &str, &str); 2] =
    [("VALUE", "value", "angular_value"), ("ERROR", "error", "angular_error")];

/// Arguments of a FIELD of six values, and the cells of three each.
const FIELD_SIX: [(&str, [&str; 2]); 2] =
    [("LENGTH", ["translation_at_preload", "rotation_at_preload"]), ("FORCE", ["force_preload", "torque_preload"])];

pub(super) const FIELD_WORDS: &[Word] =
    &[("LENGTH", Form::Value), ("FORCE", Form::Value), ("FUNCTION", Form::Function)];
pub(super) const MATRIX_WORDS: &[Word] = &[
    ("FULL", Form::Value),
    ("SPARSE", Form::Flag),
    ("ENTRIES", Form::Value),
    ("FILE", Form::Value),
    ("NAME", Form::Value),
];
pub(super) const CURVE_WORDS: &[Word] = &[
    ("OPEN", Form::Flag),
    ("CURVE_POINTS", Form::Flag),
    ("CONTROL_POINTS", Form::Flag),
    ("FUNCTION", Form::Function),
    ("ORDER", Form::Value),
];
/// How a sensor compares.
pub(super) const COMPARISONS: [&str; 3] = ["EQ", "GE", "LE"];
pub(super) const SPLINE_WORDS: &[Word] = &[("FUNCTION", Form::Function)];

/// Translation and rotation of the six values of a FIELD.
pub(super) fn read_field<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for (keyword, cells) in FIELD_SIX {
        let Some(argument) = e.take(keyword) else { continue };
        let Some(list) = b.list(argument) else { continue };
        if list.len() == 6 {
            b.set_listed(e, cells[0], argument, &list[..3]);
            b.set_listed(e, cells[1], argument, &list[3..]);
        } else {
            b.count(argument, list.len(), "6");
        }
    }
}

pub(super) fn array_kind(statement: &Statement) -> Chosen {
    let found = ARRAYS.iter().find(|(word, _)| statement.has(word));
    Chosen::Class(found.map_or("array_general", |(_, class)| class))
}

pub(super) fn read_array(e: &mut Entry<'_>) {
    if let Some((word, _)) = ARRAYS.iter().find(|(word, _)| e.statement.has(word)) {
        e.flag(word);
    }
}

pub(super) fn matrix_kind(statement: &Statement) -> Chosen {
    if statement.has("SPARSE") {
        Chosen::Class("matrix_sparse")
    } else if statement.argument("FULL").is_some() {
        Chosen::Class("matrix_full")
    } else if statement.argument("FILE").is_some() {
        Chosen::Class("matrix_file")
    } else {
        Chosen::OneOf(vec!["FULL", "SPARSE", "FILE"])
    }
}

pub(super) fn read_matrix<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    if let Some(argument) = e.take("FULL") {
        let Some((word, at)) = b.only(argument) else { return };
        let typed = word.to_ascii_uppercase();
        let order = match typed.as_str() {
            begins if !begins.is_empty() && "RORDER".starts_with(begins) => "by_row",
            begins if !begins.is_empty() && "CORDER".starts_with(begins) => "by_column",
            _ => return b.unknown_word(argument, (word, at), &["RORDER", "CORDER"]),
        };
        b.store(e.id, "input_order", Value::Text(order.to_string()));
        let size = ["ROWS", "COLUMNS"].map(|keyword| e.statement.value(keyword, b.text));
        let size = size.map(|size| size.and_then(|size| size.parse::<usize>().ok()));
        if let ([Some(rows), Some(columns)], Some(values)) = (size, e.statement.argument("VALUES")) {
            let given = values.items(b.text).len();
            if rows.checked_mul(columns) != Some(given) {
                e.take("VALUES");
                b.count(values, given, &format!("{rows} times {columns}"));
            }
        }
    }
    if e.flag("SPARSE")
        && let Some(argument) = e.take("ENTRIES")
        && let Some(entries) = b.plain(argument)
    {
        if entries.len() % 3 != 0 {
            return b.count(argument, entries.len(), "three for each entry, row, column and value:");
        }
        for (cell, offset) in [("row_index", 0), ("column_index", 1), ("values", 2)] {
            let column: Vec<f64> = entries.chunks_exact(3).map(|entry| entry[offset]).collect();
            b.store(e.id, cell, Value::Array(Array::column(column)));
        }
    }
    for (keyword, cell) in [("FILE", "file_name"), ("NAME", "name_of_matrix_in_file")] {
        if let Some(field) = Builder::field(e, cell)
            && let Some(argument) = e.take(keyword)
        {
            b.set_text(e, field, argument);
        }
    }
}

pub(super) fn read_curve<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let closed = e.statement.has("CLOSED");
    if !closed {
        e.flag("OPEN");
    }
    e.flag("CLOSED");
    b.store(e.id, "closed", Value::Flag(closed));
    let through = e.flag("CURVE_POINTS");
    e.flag("CONTROL_POINTS");
    let fit = if through { "curve_points" } else { "control_points" };
    b.store(e.id, "fit_type", Value::Text(fit.to_string()));
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
    if let Some(argument) = e.take("ORDER") {
        b.set_numbers(e, "interpolation_order", argument);
    }
}

/// A surface gives a row of values for each value of its second axis, which leads the row.
pub(super) fn read_spline<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let rows = e.take_all("Y");
    if let Some(argument) = e.statement.argument("X") {
        rising(b, e, argument);
    }
    let points = e.statement.argument("X").map(|argument| argument.items(b.text).len());
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
    if rows.len() < 2 {
        if let Some(argument) = rows.first() {
            let given = argument.items(b.text).len();
            match points.filter(|points| *points != given) {
                Some(points) => b.count(argument, given, &points.to_string()),
                None => b.set_numbers(e, "y", argument),
            }
        }
        return;
    }
    let (mut z, mut y, mut uneven) = (Vec::new(), Vec::new(), false);
    let mut width = points.map(|points| points + 1);
    for argument in rows {
        let Some(values) = b.plain(argument) else { return };
        let wanted = *width.get_or_insert(values.len());
        if values.len() != wanted {
            b.count(argument, values.len(), &wanted.to_string());
            uneven = true;
        }
        z.extend(values.first());
        y.extend(values.iter().skip(1));
    }
    // Values that no row can be told of would be cut into other rows.
    if uneven {
        return;
    }
    b.store(e.id, "z", Value::Array(Array::column(z)));
    b.store(e.id, "y", Value::Array(Array::column(y)));
}

/// Names the first value on the axis that does not rise.
fn rising(b: &mut Builder<'_>, e: &Entry<'_>, argument: &Argument) {
    let items = argument.items(b.text);
    let values: Vec<_> = items.iter().map_while(|(item, _)| parse(item)).map(|n| n.value).collect();
    let Some(at) = values.windows(2).position(|pair| pair[0] >= pair[1]).and_then(|k| items.get(k + 1)) else { return };
    let (value, at) = (at.0, b.span(&at.1));
    let message = format!("`X` of {} goes back to {value}: it must rise from value to value", e.name());
    b.report(Diagnostic::error("dataset/not-rising", message).at(at, "not above the one before"));
}

pub(super) fn read_sensor<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    if let Some(word) = e.one_of(&COMPARISONS) {
        b.store(e.id, "compare", Value::Text(word.to_ascii_lowercase()));
    }
    // A limit in degrees is one of an angle.
    for (keyword, plain, angular) in SENSOR_LIMITS {
        let Some(argument) = e.take(keyword) else { continue };
        let Some(list) = b.list(argument) else { continue };
        let cell = if list.iter().any(|(n, _)| n.degrees) { angular } else { plain };
        b.set_listed(e, cell, argument, &list);
    }
}
