//! Functions that ask which objects refer to which.

use model::{Database, Node, ObjectId, Source, Value};

use super::{Arguments, Function, database::is_type, function, searching};
use crate::{arithmetic::flag, scope::Outcome};

pub const TABLE: &[Function] = &[
    searching("DB_ACTIVE", "object", "1 if an object and all above it are active", |a| {
        let mut next = Some(a.object(0)?);
        while let Some(object) = next {
            if a.database().flag(object, "active") == Some(false) {
                return Ok(flag(false));
            }
            next = a.database().object(object).parent;
        }
        Ok(flag(true))
    }),
    searching(
        "DB_DELETE_DEPENDENTS",
        "object",
        "objects that an object's deletion would leave without what they need",
        |a| {
            let object = a.object(0)?;
            let inside = a.database().subtree(object);
            let found = dependents(a.database(), &inside, true);
            Ok(Value::Objects(found))
        },
    ),
    searching("DB_DEL_PARAM_DEPENDENTS", "object", "objects whose expressions use an object", |a| {
        let object = a.object(0)?;
        let database = a.database();
        Ok(Value::Objects(
            database.ids().filter(|o| *o != object && in_expressions(database, *o).contains(&object)).collect(),
        ))
    }),
    searching("DB_DEPENDENTS", "object, type", "objects of a type that refer to an object", |a| {
        let found = dependents(a.database(), &[a.object(0)?], false);
        of_type(a, found)
    }),
    searching(
        "DB_DEPENDENTS_EXHAUSTIVE",
        "object, type",
        "objects of a type that refer to an object, directly or not",
        |a| {
            let start = a.object(0)?;
            let database = a.database();
            let all: Vec<(ObjectId, Vec<ObjectId>)> = database.ids().map(|o| (o, referents(database, o))).collect();
            let found = chain(start, |o| all.iter().filter(|(_, used)| used.contains(&o)).map(|(o, _)| *o).collect());
            of_type(a, found)
        },
    ),
    searching("DB_REFERENTS", "object, type", "objects of a type that an object refers to", |a| {
        let found = referents(a.database(), a.object(0)?);
        of_type(a, found)
    }),
    searching(
        "DB_REFERENTS_EXHAUSTIVE",
        "object, type",
        "objects of a type that an object refers to, directly or not",
        |a| {
            let (start, database) = (a.object(0)?, a.database());
            let found = chain(start, |o| referents(database, o));
            of_type(a, found)
        },
    ),
    function("DB_TWO_WAY", "object, type", "objects of a type tied to an object both ways; here there are none", |a| {
        a.object(0)?;
        a.text(1)?;
        Ok(Value::Objects(Vec::new()))
    }),
];

fn of_type(a: &Arguments, mut found: Vec<ObjectId>) -> Outcome<Value> {
    let wanted = a.text(1)?;
    found.retain(|o| is_type(a.database(), *o, &wanted));
    Ok(Value::Objects(found))
}

/// Objects named by the cells of an object, each once, in the order of the cells.
fn referents(database: &Database, object: ObjectId) -> Vec<ObjectId> {
    let mut found: Vec<ObjectId> = Vec::new();
    for cell in database.object(object).cells.values() {
        found.extend(cell.value.objects());
        if let Value::Function(function) = &cell.value {
            found.extend(function.objects());
        }
        for expression in cell.expressions() {
            found.extend(expression.objects());
        }
    }
    once(&mut found);
    found.retain(|o| *o != object && database.get(*o).is_some());
    found
}

fn in_expressions(database: &Database, object: ObjectId) -> Vec<ObjectId> {
    let cells = database.object(object).cells.values().filter(|c| c.source != Source::Literal);
    cells.flat_map(|c| c.expressions().into_iter().flat_map(model::Expression::objects).collect::<Vec<_>>()).collect()
}

/// Objects that refer to one of several; on demand only those outside.
fn dependents(database: &Database, wanted: &[ObjectId], outside: bool) -> Vec<ObjectId> {
    let mut of_interest = wanted.to_vec();
    of_interest.sort_unstable();
    let is_wanted = |o: &ObjectId| of_interest.binary_search(o).is_ok();
    database.ids().filter(|o| !(outside && is_wanted(o)) && referents(database, *o).iter().any(is_wanted)).collect()
}

/// Everything reached by repeated steps, nearest first, without the start.
fn chain(start: ObjectId, step: impl Fn(ObjectId) -> Vec<ObjectId>) -> Vec<ObjectId> {
    let mut found = vec![start];
    let mut next = 0;
    while let Some(&object) = found.get(next) {
        for reached in step(object) {
            if !found.contains(&reached) {
                found.push(reached);
            }
        }
        next += 1;
    }
    found.remove(0);
    found
}

/// Keeps the first of equal elements.
pub(super) fn once<T: PartialEq + Copy>(list: &mut Vec<T>) {
    let mut seen: Vec<T> = Vec::with_capacity(list.len());
    list.retain(|x| {
        let new = !seen.contains(x);
        if new {
            seen.push(*x);
        }
        new
    });
}

/// Places in an expression that name an object or an attribute of one, in order of appearance.
pub(super) fn references(node: &Node, out: &mut Vec<Node>) {
    match node {
        Node::Object(_) => out.push(node.clone()),
        Node::Attribute(inner, _) if matches!(**inner, Node::Object(_)) => out.push(node.clone()),
        Node::Attribute(inner, _) | Node::Unary(_, inner) => references(inner, out),
        Node::Index(inner, list) => {
            references(inner, out);
            list.iter().for_each(|n| references(n, out));
        }
        Node::Call { arguments: list, .. } | Node::Array(list) | Node::Row(list) => {
            list.iter().for_each(|n| references(n, out));
        }
        Node::Binary(_, a, b) => [a, b].into_iter().for_each(|n| references(n, out)),
        Node::Conditional(a, b, c) => [a, b, c].into_iter().for_each(|n| references(n, out)),
        Node::Number { .. } | Node::Text(_) | Node::Nothing | Node::Constant(_) | Node::Unbound(_) => {}
    }
}
