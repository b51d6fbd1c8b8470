//! From objects to statements. What the schema says is enough for most ([`regular`]); the others
//! have a file each.

mod body;
mod constraint;
mod graphics;
mod gravity;
mod regular;
mod request;
mod settings;

pub(crate) use graphics::moves;
pub(crate) use gravity::gravity;
pub(crate) use settings::settings;

use model::{Database, ObjectId, Piece, Value};

use crate::{layout::Lines, number::number, write::Writer};

/// The statement of an object; `None` if there is none for it.
pub(crate) fn statement(w: &mut Writer<'_>, id: ObjectId) -> Option<Lines> {
    let class = w.database.object(id).class;
    let statement = class.statement?;
    let mut lines = Lines::new(statement, w.database.integer(id, "adams_id"));
    match statement {
        "PART" | "POINT_MASS" => body::body(w, id, &mut lines),
        "MARKER" => body::marker(w, id, &mut lines),
        "JOINT" | "JPRIM" => constraint::joint(w, id, &mut lines),
        "MOTION" => constraint::motion(w, id, &mut lines),
        "GRAPHICS" => return graphics::graphics(w, id, lines),
        "REQUEST" => request::request(w, id, &mut lines),
        "SFORCE" => {
            type_of_freedom(w, id, &mut lines);
            regular::arguments(w, id, &mut lines);
        }
        _ => regular::arguments(w, id, &mut lines),
    }
    Some(lines)
}

/// `TRANSLATIONAL` or `ROTATIONAL`.
fn type_of_freedom(w: &Writer<'_>, id: ObjectId, lines: &mut Lines) {
    if let Some(word) = w.database.text(id, "type_of_freedom") {
        lines.flag(&word.to_ascii_uppercase());
    }
}

/// `, I = 5` where the reference is given.
fn reference(w: &mut Writer<'_>, id: ObjectId, field: &str, keyword: &str, lines: &mut Lines) {
    if let Some(object) = w.database.reference(id, field) {
        let number = w.id_of(id, object).to_string();
        lines.argument(keyword, &number);
    }
}

/// Function text with numbers in place of names; empty if there is none. A design variable becomes
/// its value.
fn function_text(w: &mut Writer<'_>, id: ObjectId, field: &str) -> String {
    let Some(Value::Function(function)) = w.database.value(id, field) else {
        return w.database.text(id, field).unwrap_or_default().to_string();
    };
    let function = function.clone();
    let mut text = String::new();
    for piece in &function.pieces {
        match piece {
            Piece::Text(t) => text.push_str(t),
            Piece::Object(object) => {
                let value = w.database.get(*object).and_then(|o| {
                    let variable = o.class.is("variable");
                    variable.then(|| w.database.number(*object, "real_value"))?
                });
                match value {
                    // A negative value keeps its sign to itself: `2*(-3)`.
                    Some(x) if x < 0.0 => text.extend(["(", &number(x, w.options.digits), ")"]),
                    Some(x) => text.push_str(&number(x, w.options.digits)),
                    None => text.push_str(&w.id_of(id, *object).to_string()),
                }
            }
        }
    }
    text.trim().to_string()
}

/// `USER(1, 2)` from the constants handed to a subroutine.
fn user_function(w: &Writer<'_>, id: ObjectId) -> Option<String> {
    let constants = w.database.numbers(id, "user_function").filter(|c| !c.is_empty())?;
    let constants: Vec<_> = constants.iter().map(|x| number(*x, w.options.digits)).collect();
    Some(format!("USER({})", constants.join(", ")))
}

/// Writes the function, or the subroutine call, of an object.
fn function_or_user(w: &mut Writer<'_>, id: ObjectId, lines: &mut Lines) {
    let text = function_text(w, id, "function");
    let call = user_function(w, id);
    let routine = w.database.text(id, "routine").filter(|r| !r.is_empty()).map(str::to_string);
    if text.is_empty() && call.is_none() {
        let name = w.database.full_name(id);
        w.fail("dataset/no-function", format!("`{name}` has no function"));
        return;
    }
    lines.function("FUNCTION", if text.is_empty() { call.as_deref().unwrap_or_default() } else { &text });
    if let Some(routine) = routine {
        lines.end_function();
        lines.argument("ROUTINE", &routine);
    }
}

/// The strings of a cell; none if unset.
pub(crate) fn texts(database: &Database, id: ObjectId, field: &str) -> Vec<String> {
    match database.value(id, field) {
        Some(Value::Text(text)) if !text.is_empty() => vec![text.clone()],
        Some(Value::Texts(texts)) => texts.clone(),
        _ => Vec::new(),
    }
}

/// Numbers of a cell as they are written; angles of the model become radians or, alone, degrees.
fn numbers(w: &Writer<'_>, id: ObjectId, field: &schema::Field) -> Option<Vec<String>> {
    let values = w.database.numbers(id, field.name)?;
    let d = field.dimension;
    let angle = w.database.units().angle.si;
    let digits = w.options.digits;
    let written = values.into_iter().map(|x| {
        if d.angle == 1 && d.length == 0 && d.force == 0 && d.mass == 0 {
            format!("{}D", number((x * angle).to_degrees(), digits))
        } else {
            number(x * angle.powi(i32::from(d.angle)), digits)
        }
    });
    Some(written.collect())
}

/// `, VX = 5` from a field by its name, if it is set; the keyword is the field's.
fn number_field(w: &Writer<'_>, id: ObjectId, name: &str, keyword: &str, lines: &mut Lines) {
    let class = w.database.object(id).class;
    let Some(field) = class.cell_index(name).map(|index| class.field(index)) else { return };
    if let Some(values) = numbers(w, id, field) {
        lines.list(keyword, &values);
    }
}
