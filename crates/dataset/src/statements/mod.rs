//! From objects to statements and back. What the schema says is enough for most ([`regular`]); the
//! others have a file each, which writes and reads them.

mod alternatives;
mod body;
mod constraint;
mod coupled;
mod data;
mod graphics;
mod gravity;
mod reading;
mod regular;
mod request;
mod settings;
mod vector;

pub(crate) use alternatives::{Choice, choices};
pub(crate) use graphics::moves;
pub(crate) use gravity::{NAME as GRAVITY, gravity};
pub(crate) use reading::{Chosen, REQUIRED, class_of, has_number, read, required, words};
pub(crate) use regular::zero_if_left_out;
pub(crate) use settings::{is_setting, read_setting, setting_names, setting_words, settings};

use model::{Database, FunctionText, ObjectId, Piece, Value};
use syntax::function::Calls;

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
        "VFORCE" | "VTORQUE" | "GFORCE" => vector::vector(w, id, &mut lines),
        "COUPLER" => coupled::coupler(w, id, &mut lines),
        "PTCV" => coupled::point_curve(w, id, &mut lines),
        "CONTACT" => coupled::contact(w, id, &mut lines),
        "DIFF" => coupled::differential_equation(w, id, &mut lines),
        "FIELD" => data::field(w, id, &mut lines),
        "ARRAY" => data::array(w, id, &mut lines),
        "MATRIX" => data::matrix(w, id, &mut lines),
        "CURVE" => data::curve(w, id, &mut lines),
        "SPLINE" => data::spline(w, id, &mut lines),
        "SENSOR" => data::sensor(w, id, &mut lines),
        "GSE" => data::general_equation(w, id, &mut lines),
        "CVCV" => coupled::curve_curve(w, id, &mut lines),
        "SPRINGDAMPER" => {
            let turns = class.id == "rotational_spring_damper";
            reference(w, id, "i_marker_name", "I", &mut lines);
            reference(w, id, "j_marker_name", "J", &mut lines);
            lines.flag(if turns { "ROTATIONAL" } else { "TRANSLATIONAL" });
            regular::without_ends(w, id, &mut lines);
        }
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
        let number = w.id_of(id, object);
        lines.argument(keyword, &number);
    }
}

/// Function text with numbers in place of names; empty if there is none. A design variable becomes
/// its value. Names that mean no object are failures: the solver knows numbers only.
fn function_text(w: &mut Writer<'_>, id: ObjectId, field: &str) -> String {
    let function = match w.database.value(id, field) {
        Some(Value::Function(function)) => function.clone(),
        _ => FunctionText::plain(w.database.text(id, field).unwrap_or_default()),
    };
    let mut text = String::new();
    let mut before = None;
    let mut calls = Calls::default();
    for piece in &function.pieces {
        match piece {
            Piece::Text(t) => {
                calls.read(t);
                for name in unbound_names(t, before) {
                    let user = w.database.full_name(id);
                    w.fail("dataset/unknown-name", format!("`{user}` refers to `{name}`, which is no object"));
                }
                text.push_str(t);
                before = t.chars().last();
            }
            Piece::Object(object) => {
                let wanted = calls.place().map_or(&[][..], |(function, at)| schema::referred(function, at));
                refuse_other_class(w, id, *object, wanted);
                calls.read_object();
                let value = bound(w, id, *object);
                text.push_str(&value);
                before = value.chars().last();
            }
        }
    }
    text.trim().to_string()
}

/// Refuses an object where the solver would take its number for that of another: ids are unique
/// within a statement only.
fn refuse_other_class(w: &mut Writer<'_>, id: ObjectId, object: ObjectId, wanted: &[&str]) {
    // A variable may hold the object.
    let held = w.database.get(object).and_then(|_| w.database.value(object, "object_value")).map(Value::objects);
    let object = held.and_then(|held| held.first().copied()).unwrap_or(object);
    let Some(found) = w.database.get(object) else { return };
    let (Some(proper), Some(statement)) = (wanted.first(), found.class.statement) else { return };
    if statement != *proper {
        let (user, name, word) = (w.database.full_name(id), w.database.full_name(object), found.class.word);
        let message = format!("the function of `{user}` needs a {proper} where it names `{name}`, a {word}");
        w.fail("dataset/wrong-object", message);
    }
}

/// What stands in a function for an object: the value of a variable, the number of anything else.
fn bound(w: &mut Writer<'_>, id: ObjectId, object: ObjectId) -> String {
    if w.database.get(object).is_some_and(|o| o.class.is("variable")) {
        let value = ["real_value", "integer_value"].iter().find_map(|field| w.database.number(object, field));
        if let Some(x) = value {
            let written = number(x, w.options.digits);
            // A negative value keeps its sign to itself: `2*(-3)`.
            return if x < 0.0 { format!("({written})") } else { written };
        }
        // A variable may name an object in place of a number.
        let named = w.database.value(object, "object_value").map(Value::objects).unwrap_or_default();
        if let [named] = named.as_slice() {
            return w.id_of(id, *named);
        }
    }
    w.id_of(id, object)
}

/// Names in the plain text of a function, which are neither functions nor constants of the solver;
/// `before` is what stands before the text.
fn unbound_names(text: &str, mut before: Option<char>) -> Vec<&str> {
    const WORDS: &[&str] = &["time", "pi", "dtor", "rtod", "mode"];
    let part_of_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '"');
    let mut names = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let mut quoted = false;
        let ends = |c: char| {
            quoted ^= c == '"';
            !quoted && !part_of_name(c)
        };
        let length = rest.find(ends).unwrap_or(rest.len()).max(c.len_utf8());
        let (word, after) = rest.split_at(length);
        // What goes on behind an object is a component of it, which has no number.
        let behind = before.is_some_and(part_of_name) && c == '.';
        let begins = |c: char| c.is_alphabetic() || matches!(c, '_' | '"');
        let dotted = c == '.' && word[1..].starts_with(begins);
        let call = || after.trim_start().starts_with('(') && !word.contains('.');
        if behind || dotted || (begins(c) && !call() && !WORDS.iter().any(|w| w.eq_ignore_ascii_case(word))) {
            names.push(word);
        }
        before = word.chars().last();
        rest = after;
    }
    names
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
    let degrees = is_angle(field.dimension);
    let values = w.plain_numbers(id, field.name)?;
    let written = values.into_iter().map(|x| {
        let written = number(x, w.options.digits);
        if degrees { written + "D" } else { written }
    });
    Some(written.collect())
}

/// Whether values of a dimension are angles and nothing else.
pub(crate) fn is_angle(d: schema::Dimension) -> bool {
    d.angle == 1 && d.length == 0 && d.force == 0 && d.mass == 0 && d.time == 0
}

/// `, VX = 5` from a field by its name, if it is set; the keyword is the field's.
fn number_field(w: &Writer<'_>, id: ObjectId, name: &str, keyword: &str, lines: &mut Lines) {
    let class = w.database.object(id).class;
    let Some(field) = class.cell_index(name).map(|index| class.field(index)) else { return };
    if let Some(values) = numbers(w, id, field) {
        lines.list(keyword, &values);
    }
}

#[cfg(test)]
mod tests {
    use super::unbound_names;

    #[test]
    fn names_are_told_from_numbers_constants_and_calls() {
        for (text, names) in [
            ("30.0d * time + .5*PI - 1.E-3*STEP (TIME, 0, 0, 1D, 1)**2", &[][..]),
            ("VARVAL(.m.x)*30/PI", &[".m.x"]),
            ("VARVAL(x_1) + IF(TIME-1: .m.\"a b\", 0, 1)", &["x_1", ".m.\"a b\""]),
            ("-DTOR*.2/RTOD", &[]),
            ("USER(1, 2.5e+3)", &[]),
        ] {
            assert_eq!(unbound_names(text, None), names, "{text}");
        }
        assert_eq!(unbound_names(".F1*2", Some('7')), [".F1"]);
        assert!(unbound_names("*.5", Some('7')).is_empty());
    }
}
