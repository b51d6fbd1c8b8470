//! `* copy`: an object with everything below it once more, under another name.

use std::collections::HashMap;

use model::{Cell, CellKey, Database, Expression, FunctionText, Node, ObjectId, Piece, Source, Value};
use schema::{Field, Kind, Names, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup};

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "copies an object and what is below it" }, copy)
}

const fn old(name: &'static str, class: &'static str) -> Field {
    Field::object(name, class).current().doc("object to copy")
}

const fn new(name: &'static str, class: &'static str) -> Field {
    Field::new(name, Kind::Object(Names::New, class)).doc("name of the copy")
}

pub const MODEL: VerbEntry = verb("model copy", &[old("model_name", "model"), new("new_model_name", "model")]);
pub const PART: VerbEntry = verb("part copy", &[old("part_name", "body"), new("new_part_name", "body")]);
pub const MARKER: VerbEntry = verb("marker copy", &[old("marker_name", "marker"), new("new_marker_name", "marker")]);
pub const POINT: VerbEntry = verb("point copy", &[old("point_name", "point"), new("new_point_name", "point")]);
pub const FORCE: VerbEntry = verb("force copy", &[old("force_name", "force"), new("new_force_name", "force")]);
pub const CONSTRAINT: VerbEntry =
    verb("constraint copy", &[old("constraint_name", "constraint"), new("new_constraint_name", "constraint")]);
pub const GEOMETRY: VerbEntry =
    verb("geometry copy", &[old("geometry_name", "geometry"), new("new_geometry_name", "geometry")]);
pub const DATA_ELEMENT: VerbEntry = verb(
    "data_element copy",
    &[old("data_element_name", "data_element"), new("new_data_element_name", "data_element")],
);
pub const ENTITY: VerbEntry = verb("entity copy", &[old("entity_name", "any"), new("new_entity_name", "any")]);

fn copy(interpreter: &mut Interpreter, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
    let [old, new] = [0, 1].map(|i| call.parameters[i].clone());
    let wanted = match old.field.kind {
        Kind::Object(_, wanted) => wanted,
        _ => "any",
    };
    let Some(id) = interpreter.object_argument(call, &old.name)?.or_else(|| interpreter.database.current(wanted))
    else {
        return Err(vec![call.missing(&[&old.name])]);
    };
    let object = interpreter.database.object(id);
    let (class, parent) = (object.class, object.parent);
    let (place, typed, span) = if let Some(argument) = call.argument(&new.name) {
        let typed = interpreter.text_argument(call, argument)?;
        let mut place =
            lookup::new_name(&interpreter.database, &interpreter.registry, class, &typed, argument.value_span)
                .map_err(|e| vec![e])?;
        if !typed.starts_with('.') {
            place.parent = parent;
        }
        (place, typed, argument.value_span)
    } else {
        let name = interpreter.generate_name(class, parent);
        (lookup::NewName { parent, name: name.clone() }, name, call.keywords)
    };
    let sources = interpreter.database.subtree(id);
    let mut twins: HashMap<ObjectId, ObjectId> = HashMap::new();
    for &source in &sources {
        let object = interpreter.database.object(source);
        let (class, name) = (object.class, if source == id { place.name.clone() } else { object.name.clone() });
        let parent = if source == id { place.parent } else { object.parent.and_then(|p| twins.get(&p).copied()) };
        let twin = interpreter
            .database
            .create(class, parent, &name)
            .map_err(|t| vec![lookup::taken(&interpreter.database, class, &typed, t.0, span)])?;
        twins.insert(source, twin);
    }
    for source in sources {
        let twin = twins[&source];
        for index in 0..interpreter.database.object(source).cells.len() {
            let Some(cell) = interpreter.database.object(source).cells[index].clone() else { continue };
            let key = CellKey::new(source, index);
            let reads = interpreter.database.reads(key).to_vec();
            let moved = reads.iter().map(|r| CellKey { object: *twins.get(&r.object).unwrap_or(&r.object), ..*r });
            let moved = moved.collect();
            let own_id = interpreter.database.object(source).class.field(index).name == "adams_id";
            let cell = if own_id {
                Cell { value: Value::Integer(0), source: Source::Literal, ..cell }
            } else {
                moved_cell(&cell, &twins, &interpreter.database)
            };
            let key = CellKey::new(twin, index);
            interpreter.database.set_reads(key, moved);
            interpreter.database.set_cell(key, Some(cell));
        }
    }
    interpreter.names.forget();
    interpreter.database.make_current(twins[&id]);
    Ok(Flow::Next)
}

fn moved_cell(cell: &Cell, twins: &HashMap<ObjectId, ObjectId>, _: &Database) -> Cell {
    let at = |id: &ObjectId| *twins.get(id).unwrap_or(id);
    let value = match &cell.value {
        Value::Object(id) => Value::Object(at(id)),
        Value::Objects(ids) => Value::Objects(ids.iter().map(at).collect()),
        Value::Function(f) => Value::Function(FunctionText {
            pieces: f
                .pieces
                .iter()
                .map(|p| match p {
                    Piece::Object(id) => Piece::Object(at(id)),
                    Piece::Text(text) => Piece::Text(text.clone()),
                })
                .collect(),
        }),
        other => other.clone(),
    };
    let source = match &cell.source {
        Source::Literal => Source::Literal,
        Source::Expression(e) => Source::Expression(Box::new(Expression { root: moved_node(&e.root, &at) })),
        Source::Elements(list) => Source::Elements(
            list.iter().map(|e| e.as_ref().map(|e| Expression { root: moved_node(&e.root, &at) })).collect(),
        ),
    };
    Cell { value, units: cell.units, source }
}

fn moved_node(node: &Node, at: &impl Fn(&ObjectId) -> ObjectId) -> Node {
    let one = |n: &Node| Box::new(moved_node(n, at));
    let all = |list: &[Node]| list.iter().map(|n| moved_node(n, at)).collect();
    match node {
        Node::Object(id) => Node::Object(at(id)),
        Node::Attribute(inner, name) => Node::Attribute(one(inner), name.clone()),
        Node::Index(inner, list) => Node::Index(one(inner), all(list)),
        Node::Call { function, arguments } => Node::Call { function: function.clone(), arguments: all(arguments) },
        Node::Unary(op, a) => Node::Unary(*op, one(a)),
        Node::Binary(op, a, b) => Node::Binary(*op, one(a), one(b)),
        Node::Conditional(a, b, c) => Node::Conditional(one(a), one(b), one(c)),
        Node::Array(list) => Node::Array(all(list)),
        Node::Row(list) => Node::Row(all(list)),
        other => other.clone(),
    }
}
