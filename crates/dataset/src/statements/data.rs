//! FIELD and the data elements whose words do not follow from the schema alone: ARRAY, MATRIX, CURVE,
//! SPLINE, SENSOR.

use model::{Array, Value};

use super::Chosen;
use crate::read::{Builder, Entry, Form, Statement, Word};

pub(super) const FIELD_WORDS: &[Word] =
    &[("LENGTH", Form::Value), ("FORCE", Form::Value), ("FUNCTION", Form::Function)];
pub(super) const ARRAY_WORDS: &[Word] = &[("IC", Form::Flag), ("X", Form::Flag), ("U", Form::Flag), ("Y", Form::Flag)];
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
pub(super) const SENSOR_WORDS: &[Word] = &[("EQ", Form::Flag), ("GE", Form::Flag), ("LE", Form::Flag)];
pub(super) const SPLINE_WORDS: &[Word] = &[("FUNCTION", Form::Function)];

/// Translation and rotation of the six values of a FIELD.
pub(super) fn read_field<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for (keyword, cells) in
        [("LENGTH", ["translation_at_preload", "rotation_at_preload"]), ("FORCE", ["force_preload", "torque_preload"])]
    {
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

pub(super) fn array(statement: &Statement) -> Chosen {
    let kinds = [("X", "array_x"), ("U", "array_u"), ("Y", "array_y"), ("IC", "array_ic")];
    let found = kinds.iter().find(|(word, _)| statement.has(word));
    Chosen::Class(found.map_or("array_general", |(_, class)| class))
}

pub(super) fn read_array(e: &mut Entry<'_>) {
    e.one_of(&["X", "U", "Y", "IC"]);
}

pub(super) fn matrix(statement: &Statement) -> Chosen {
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
        let typed = argument.value(b.text).to_ascii_uppercase();
        let order = if !typed.is_empty() && "RORDER".starts_with(&typed) {
            "by_row"
        } else if !typed.is_empty() && "CORDER".starts_with(&typed) {
            "by_column"
        } else {
            return b.unknown_word(argument, &typed, &["RORDER", "CORDER"]);
        };
        b.store(e.id, "input_order", Value::Text(order.to_string()));
    }
    if e.flag("SPARSE")
        && let Some(argument) = e.take("ENTRIES")
        && let Some(entries) = b.plain(argument)
    {
        if entries.len() % 3 != 0 {
            b.count(argument, entries.len(), "three for each entry: row, column,");
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
    if let Some(argument) = e.take("FUNCTION") {
        b.set_function(e, "function", argument);
    }
    if rows.len() < 2 {
        if let Some(argument) = rows.first() {
            b.set_numbers(e, "y", argument);
        }
        return;
    }
    let (mut z, mut y) = (Vec::new(), Vec::new());
    for argument in rows {
        let Some(values) = b.plain(argument) else { return };
        z.extend(values.first());
        y.extend(values.iter().skip(1));
    }
    b.store(e.id, "z", Value::Array(Array::column(z)));
    b.store(e.id, "y", Value::Array(Array::column(y)));
}

pub(super) fn read_sensor<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    if let Some(word) = e.one_of(&["EQ", "GE", "LE"]) {
        b.store(e.id, "compare", Value::Text(word.to_ascii_lowercase()));
    }
    // A limit in degrees is one of an angle.
    for (keyword, plain, angular) in [("VALUE", "value", "angular_value"), ("ERROR", "error", "angular_error")] {
        let Some(argument) = e.take(keyword) else { continue };
        let Some(list) = b.list(argument) else { continue };
        let cell = if list.iter().any(|(n, _)| n.degrees) { angular } else { plain };
        b.set_listed(e, cell, argument, &list);
    }
}
