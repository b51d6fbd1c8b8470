//! `list_info ...`: the values of objects, one line each. The layout is our own.

use model::{ObjectId, Value};
use schema::{Field, Kind, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, evaluation, interpreter::Flow, number, values::text_of};

const BRIEF: Field = Field::on_off("brief").doc("short form");
const SHOW: Field = Field::on_off("write_to_terminal").doc("show the listing");
const FILE: Field = Field::text("file_name").doc("file for the listing");
const LEVELS: Field = Field::integer("influencer_levels").doc("levels of objects this one depends on");

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "lists the values of objects" }, list)
}

const fn of(name: &'static str, class: &'static str) -> Field {
    Field::objects(name, class).current().doc("objects to list")
}

pub const ENTITY: VerbEntry = verb(
    "list_info entity",
    &[
        of("entity_name", "any"),
        LEVELS,
        Field::text("type_filter").doc("take only objects of this type"),
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const FORCE: VerbEntry = verb(
    "list_info force",
    &[of("force_name", "force"), of("beam_name", "beam"), of("gravity_field_name", "gravity"), BRIEF, SHOW, FILE],
);
pub const PART: VerbEntry =
    verb("list_info part", &[of("part_name", "body"), of("point_mass_name", "point_mass"), LEVELS, BRIEF, SHOW, FILE]);
pub const MARKER: VerbEntry = verb("list_info marker", &[of("marker_name", "marker"), LEVELS, BRIEF, SHOW, FILE]);
pub const MODEL: VerbEntry = verb("list_info model", &[of("model_name", "model"), BRIEF, SHOW, FILE]);
pub const VARIABLE: VerbEntry = verb("list_info variable", &[of("variable_name", "variable"), BRIEF, SHOW, FILE]);
pub const CONSTRAINT: VerbEntry = verb(
    "list_info constraint",
    &[
        of("constraint_name", "constraint"),
        of("joint_name", "constraint"),
        of("motion_name", "motion"),
        BRIEF,
        SHOW,
        FILE,
    ],
);

fn list(interpreter: &mut Interpreter, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
    let mut ids = Vec::new();
    for (parameter, argument) in call.objects() {
        ids.extend(interpreter.read_value(call, &parameter.field, argument, None)?.value.objects());
    }
    if ids.is_empty() {
        let Some(first) = call.parameters.first() else { return Ok(Flow::Next) };
        let wanted = match first.field.kind {
            Kind::Object(_, wanted) => wanted,
            _ => "any",
        };
        match interpreter.database.current(wanted) {
            Some(id) => ids.push(id),
            None => return Err(vec![call.missing(&[&*first.name])]),
        }
    }
    if let Some(wanted) = interpreter.word_of(call, "type_filter")? {
        let wanted = wanted.to_ascii_lowercase();
        ids.retain(|id| interpreter.database.object(*id).class.is(&wanted));
    }
    let in_full = interpreter.flag_argument(call, "brief")? == Some(false);
    let mut lines = Vec::new();
    for id in ids {
        if !lines.is_empty() {
            lines.push(String::new());
        }
        describe(interpreter, id, in_full, &mut lines);
    }
    if interpreter.flag_argument(call, "write_to_terminal")? != Some(false) {
        interpreter.show(&lines);
    }
    interpreter.write_lines(call, "file_name", &lines)?;
    Ok(Flow::Next)
}

/// The values of an object; in full also what has no value, and what others are computed from.
fn describe(interpreter: &Interpreter, id: ObjectId, in_full: bool, lines: &mut Vec<String>) {
    let database = &interpreter.database;
    let object = database.object(id);
    lines.push(format!("Object Name     : {}", database.full_name(id)));
    lines.push(format!("Object Type     : {}", object.class.word));
    if let Some(parent) = object.parent {
        lines.push(format!("Parent Type     : {}", database.object(parent).class.word));
    }
    for (index, field) in object.class.fields().enumerate() {
        let Some(cell) = object.cells.get(index).and_then(Option::as_ref) else {
            if in_full {
                lines.push(format!("{:<16}: (not set)", field.name));
            }
            continue;
        };
        let text = match &cell.value {
            Value::Number(_) | Value::Array(_) => {
                let numbers = database.numbers(id, field.name).unwrap_or_default();
                numbers.iter().map(|x| number::real(*x)).collect::<Vec<_>>().join(", ")
            }
            other => text_of(other, database),
        };
        let unit = database.units().label(field.dimension);
        let unit = if unit.is_empty() { unit } else { format!(" ({unit})") };
        lines.push(format!("{:<16}: {text}{unit}", field.name));
        if in_full {
            let computed = cell.expressions().into_iter().map(|e| evaluation::print(e, database));
            lines.extend(computed.map(|e| format!("{:<16}  = ({e})", "")));
        }
    }
}
