//! The lines of listings: objects from the tables of their classes, connections of parts, settings.

use model::{Cell, Database, ObjectId, Value};
use schema::{Field, Use};

use crate::{Interpreter, evaluation, number, values::text_of};

fn line(label: &str, value: &str) -> String {
    format!("{label:<16}: {value}").trim_end().to_string()
}

/// A number that was computed, without the noise of its last digits.
pub fn shown(x: f64) -> String {
    number::real(format!("{x:.9e}").parse().unwrap_or(x))
}

/// One object: what it is, then its values. The long form adds where it is, expressions, parameters
/// that are not set, what is below it and what refers to it.
pub fn describe(interpreter: &Interpreter, id: ObjectId, brief: bool, lines: &mut Vec<String>) {
    let database = &interpreter.database;
    let object = database.object(id);
    lines.push(line("Object Name", &database.full_name(id)));
    lines.push(line("Object Type", object.class.word));
    if let Some(parent) = object.parent {
        lines.push(line("Parent Type", database.object(parent).class.word));
    }
    let has = |name: &str| object.class.cell_index(name).is_some();
    if has("adams_id") {
        lines.push(line("Adams ID", &database.integer(id, "adams_id").unwrap_or(0).to_string()));
    }
    if has("active") {
        lines.push(line("Active", database.text(id, "active").unwrap_or("no_opinion")));
    }
    for (index, field) in object.class.fields().enumerate() {
        let first = object.class.cell_index(field.name) == Some(index);
        if matches!(field.name, "adams_id" | "active") || !first {
            continue;
        }
        match object.cells.get(index) {
            Some(cell) => lines.extend(value_lines(database, id, field, cell, brief)),
            // What only creates (places of markers that are made) is no value of the object.
            None if !brief && field.usage != Use::Create => lines.push(line(field.name, "(not set)")),
            None => {}
        }
    }
    if brief {
        return;
    }
    if object.class.fields().any(|f| f.name == "location" && f.usage != Use::Create) {
        let pose = database.global_pose(id);
        let unit = database.units().label(schema::Dimension::LENGTH);
        let numbers = |v: [f64; 3]| v.map(shown).join(", ");
        lines.push(format!("{} ({unit})", line("Global location", &numbers(pose.origin.to_array()))));
        for (axis, column) in ["x", "y", "z"].iter().zip(0..3) {
            lines.push(line(&format!("Global {axis} axis"), &numbers(pose.rotation.col(column).to_array())));
        }
    }
    let children: Vec<String> = object.children.iter().map(|c| database.full_name(*c)).collect();
    if !children.is_empty() {
        lines.push(line("Children", &children.join(", ")));
    }
    let users: Vec<String> = interpreter.dependents_of(&[id]).iter().map(|d| database.full_name(*d)).collect();
    if !users.is_empty() {
        lines.push(line("Referred to by", &users.join(", ")));
    }
}

fn value_lines(database: &Database, id: ObjectId, field: &Field, cell: &Cell, brief: bool) -> Vec<String> {
    let text = match &cell.value {
        Value::Number(_) | Value::Array(_) => {
            let numbers = database.numbers(id, field.name).unwrap_or_default();
            numbers.iter().map(|x| number::real(number::ten_decimals(*x))).collect::<Vec<_>>().join(", ")
        }
        Value::Flag(flag) => match field.kind {
            schema::Kind::Boolean(yes, no) => (if *flag { yes } else { no }).to_string(),
            _ => i64::from(*flag).to_string(),
        },
        other => text_of(other, database),
    };
    let unit = database.units().label(database.dimension(id, field));
    let unit = if unit.is_empty() { unit } else { format!(" ({unit})") };
    let mut lines = vec![line(field.name, &format!("{text}{unit}"))];
    if !brief {
        let computed = cell.expressions().into_iter().map(|e| evaluation::print(e, database));
        lines.extend(computed.map(|e| format!("{:<16}  = ({e})", "")));
    }
    lines
}

/// What an object depends on, so many levels deep, each once.
pub fn influencers(interpreter: &Interpreter, id: ObjectId, levels: usize, lines: &mut Vec<String>) {
    let database = &interpreter.database;
    let (mut seen, mut level) = (vec![id], vec![id]);
    for depth in 1..=levels.min(100) {
        let mut next: Vec<ObjectId> = Vec::new();
        for id in level {
            for cell in database.object(id).cells.values() {
                let named = cell.value.objects().into_iter();
                let read = cell.expressions().into_iter().flat_map(model::Expression::objects);
                for other in named.chain(read).filter(|o| database.get(*o).is_some()) {
                    if !seen.contains(&other) {
                        seen.push(other);
                        next.push(other);
                    }
                }
            }
        }
        if next.is_empty() {
            return;
        }
        let names: Vec<String> = next.iter().map(|o| database.full_name(*o)).collect();
        lines.push(line(&format!("Depends on ({depth})"), &names.join(", ")));
        level = next;
    }
}

/// The body that an object is or belongs to.
fn body_of(database: &Database, id: ObjectId) -> Option<ObjectId> {
    let mut next = Some(id);
    while let Some(object) = next {
        if database.object(object).class.is("body") {
            return Some(object);
        }
        next = database.object(object).parent;
    }
    None
}

/// Elements of a model that refer to markers or parts of bodies, with these bodies.
fn connections(database: &Database, model: ObjectId) -> Vec<(ObjectId, Vec<ObjectId>)> {
    let mut found = Vec::new();
    for id in database.subtree(model) {
        let class = database.object(id).class;
        if !["constraint", "force", "contact"].iter().any(|f| class.is(f)) {
            continue;
        }
        let mut bodies: Vec<ObjectId> = Vec::new();
        for other in database.object(id).cells.values().flat_map(|c| match &c.value {
            Value::Function(_) => Vec::new(),
            value => value.objects(),
        }) {
            if let Some(body) = database.get(other).and_then(|_| body_of(database, other))
                && !bodies.contains(&body)
            {
                bodies.push(body);
            }
        }
        if !bodies.is_empty() {
            found.push((id, bodies));
        }
    }
    found
}

/// Which elements connect which bodies.
pub fn topology(database: &Database, model: ObjectId, by_parts: bool, brief: bool, lines: &mut Vec<String>) {
    let connections = connections(database, model);
    let names = |ids: &[ObjectId]| ids.iter().map(|i| database.full_name(*i)).collect::<Vec<_>>().join(", ");
    let kind = |id: ObjectId| if brief { String::new() } else { format!(" ({})", database.object(id).class.word) };
    lines.push(line("Topology of", &database.full_name(model)));
    if !by_parts {
        for (element, bodies) in &connections {
            lines.push(format!("{}{} : {}", database.full_name(*element), kind(*element), names(bodies)));
        }
        return;
    }
    for body in database.below(model, "body") {
        lines.push(database.full_name(body));
        let mut any = false;
        for (element, bodies) in connections.iter().filter(|(_, b)| b.contains(&body)) {
            any = true;
            let others: Vec<ObjectId> = bodies.iter().copied().filter(|b| *b != body).collect();
            let others = if others.is_empty() { "itself".to_string() } else { names(&others) };
            lines.push(format!("   {}{} : {others}", database.full_name(*element), kind(*element)));
        }
        if !any {
            lines.push("   not connected".to_string());
        }
    }
}

/// Units, frames, current objects; in the long form every default that was set.
pub fn defaults(interpreter: &Interpreter, brief: bool) -> Vec<String> {
    let database = &interpreter.database;
    let (settings, units) = (database.settings(), database.units());
    let mut lines = Vec::new();
    for (label, unit) in [
        ("Length", units.length),
        ("Mass", units.mass),
        ("Force", units.force),
        ("Time", units.time),
        ("Angle", units.angle),
        ("Frequency", units.frequency),
    ] {
        lines.push(line(label, unit.name));
    }
    lines.push(line("Coordinates", &format!("{:?}", settings.coordinate_system).to_lowercase()));
    let axes: String = settings.sequence.axes.iter().map(|a| char::from(b'1' + a)).collect();
    lines.push(line("Orientation", &format!("{}{axes}", if settings.sequence.body { "body" } else { "space" })));
    let frame = settings.default_frame.filter(|f| database.get(*f).is_some());
    lines.push(line("Default frame", &frame.map_or("global".to_string(), |f| database.full_name(f))));
    for (label, wanted) in [("Current model", "model"), ("Current part", "body"), ("Current marker", "marker")] {
        if let Some(id) = database.current(wanted) {
            lines.push(line(label, &database.full_name(id)));
        }
    }
    if !brief {
        lines.extend(settings.words.iter().map(|(name, word)| line(name, word)));
    }
    lines
}
