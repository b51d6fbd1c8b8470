//! Functions that ask the modelling database about objects and their cells.

use model::{Database, ObjectId, Value, quoted};

use super::{Arguments, Function, function, momentary, searching};
use crate::pattern::glob;
use crate::{
    arithmetic::flag,
    attributes::{attribute, type_word},
    names::{Steps, find_object, reach},
    scope::Outcome,
};

pub const TABLE: &[Function] = &[
    searching("DB_ANCESTOR", "object, type", "nearest object of a type above an object", |a| {
        let (object, wanted) = (a.object(0)?, a.text(1)?);
        let mut next = a.database().object(object).parent;
        while let Some(parent) = next {
            if is_type(a.database(), parent, &wanted) {
                return Ok(Value::Object(parent));
            }
            next = a.database().object(parent).parent;
        }
        Ok(Value::Nothing)
    }),
    momentary("DB_CHANGED", "", "1 if the model has been changed in this session", |a| {
        Ok(flag(a.database().revision() > 0))
    }),
    searching("DB_CHILDREN", "object, type", "all objects of a type below an object", |a| below(a, usize::MAX)),
    function("DB_COUNT", "object, field", "number of values in a field", |a| {
        let (object, name) = (a.object(0)?, a.text(1)?);
        let value = a.evaluator.attribute(object, &name)?;
        Ok(count(match value {
            Value::Array(array) => array.values.len(),
            Value::Texts(list) => list.len(),
            Value::Objects(list) => list.len(),
            Value::Nothing => 0,
            _ => 1,
        }))
    }),
    function("DB_DEFAULT", "defaults, type", "current default object of a type", |a| {
        let wanted = a.text(1)?.to_ascii_lowercase();
        Ok(current(a.database(), &wanted).map_or(Value::Nothing, Value::Object))
    }),
    function("DB_DEFAULT_NAME", "defaults, type", "full name of the current default object of a type", |a| {
        let wanted = a.text(1)?.to_ascii_lowercase();
        let found = current(a.database(), &wanted);
        Ok(Value::Text(found.map_or_else(String::new, |o| a.database().full_name(o))))
    }),
    searching("DB_DEFAULT_NAME_FOR_TYPE", "object, type", "shortest name that means an object", |a| {
        a.text(1)?;
        Ok(Value::Text(short_name(a.database(), a.object(0)?)))
    }),
    searching(
        "DB_DESCENDANTS",
        "object, type, activity, levels",
        "objects below an object, chosen by type, activity and depth",
        |a| {
            let levels = a.count(3)?;
            let Value::Objects(mut found) = below(a, if levels == 0 { usize::MAX } else { levels })? else {
                return Ok(Value::Nothing);
            };
            let wanted = a.integer(2)?;
            let database = a.database();
            found.retain(|&o| {
                let own = database.flag(o, "active").unwrap_or(true);
                let parent = database.model_of(o).is_none_or(|m| database.flag(m, "active").unwrap_or(true));
                match wanted {
                    -1 => !(own && parent),
                    1 => parent,
                    2 => own && parent,
                    _ => true,
                }
            });
            Ok(Value::Objects(found))
        },
    ),
    searching("DB_EXISTS", "name", "1 if an object or field has this name", |a| {
        Ok(flag(match &a.values[0] {
            Value::Text(name) => names_something(a.database(), name),
            other => other.as_object().is_some_and(|o| a.database().get(o).is_some()),
        }))
    }),
    searching("DB_FILTER_NAME", "objects, pattern", "objects whose names fit a pattern", |a| {
        let (mut objects, pattern) = (a.objects(0)?, a.text(1)?);
        objects.retain(|o| a.database().get(*o).is_some_and(|o| glob(&pattern, &o.name)));
        Ok(Value::Objects(objects))
    }),
    function("DB_FILTER_TYPE", "objects, type", "objects of a type", |a| {
        let (mut objects, wanted) = (a.objects(0)?, a.text(1)?);
        objects.retain(|o| is_type(a.database(), *o, &wanted));
        Ok(Value::Objects(objects))
    }),
    searching("DB_FULL_NAME_FROM_SHORT", "name", "full name of the object that a short name means", |a| {
        let name = a.text(0)?;
        Ok(Value::Text(find_object(a.database(), &name).map_or_else(String::new, |o| a.database().full_name(o))))
    }),
    searching("DB_IMMEDIATE_CHILDREN", "object, type", "objects of a type directly below an object", |a| below(a, 1)),
    function("DB_OBJECT_COUNT", "objects", "number of objects", |a| Ok(count(a.objects(0)?.len()))),
    searching("DB_OBJ_EXISTS", "parent, name", "1 if an object has a child of this name", |a| {
        let (parent, name) = (a.object(0)?, a.text(1)?);
        Ok(flag(!a.database().children_named(Some(parent), &name).is_empty()))
    }),
    searching("DB_OBJ_EXISTS_EXHAUSTIVE", "parent, name", "1 if anything below an object has this name", |a| {
        let (parent, name) = (a.object(0)?, a.text(1)?);
        Ok(flag(named_below(a.database(), parent, &name).next().is_some()))
    }),
    searching("DB_OBJ_FROM_NAME_TYPE", "parent, name, type", "object of a name and type below another", |a| {
        let (parent, name, wanted) = (a.object(0)?, a.text(1)?, a.text(2)?);
        let database = a.database();
        let found = named_below(database, parent, &name).find(|o| is_type(database, *o, &wanted));
        Ok(found.map_or(Value::Nothing, Value::Object))
    }),
    searching("DB_OLDEST_ANCESTOR", "object, type", "highest object of a type above an object", |a| {
        let (object, wanted) = (a.object(0)?, a.text(1)?);
        let database = a.database();
        let above = std::iter::successors(database.object(object).parent, |o| database.object(*o).parent);
        Ok(above.filter(|o| is_type(database, *o, &wanted)).last().map_or(Value::Nothing, Value::Object))
    }),
    function("DB_OF_CLASS", "object, type", "1 if an object is of a type or class", |a| {
        let (object, wanted) = (a.object(0)?, a.text(1)?);
        Ok(flag(is_type(a.database(), object, &wanted)))
    }),
    searching("DB_OF_TYPE_EXISTS", "name, type", "1 if an object of this name and type exists", |a| {
        let (name, wanted) = (a.text(0)?, a.text(1)?);
        Ok(flag(of_type_exists(a.database(), &name, &wanted)))
    }),
    searching("DB_SHORT_NAME", "object", "shortest name that means this object alone", |a| {
        Ok(Value::Text(short_name(a.database(), a.object(0)?)))
    }),
    function("DB_TYPE", "object", "type of an object", |a| Ok(Value::Text(type_word(a.database(), a.object(0)?)))),
    momentary("UNIQUE_FULL_NAME", "type", "full name that is free for a new object of a type", |a| {
        let wanted = a.text(0)?.to_ascii_lowercase();
        let under_part = matches!(wanted.as_str(), "marker" | "point");
        let parent =
            if under_part { a.database().current("part") } else { None }.or_else(|| a.database().current("model"));
        Ok(Value::Text(match parent {
            Some(parent) => {
                let name = unique_below(a.database(), Some(parent), &wanted.to_ascii_uppercase());
                format!("{}.{}", a.database().full_name(parent), quoted(&name))
            }
            None => String::new(),
        }))
    }),
    momentary("UNIQUE_ID", "type", "identifier that is free for a new object of a type", |a| {
        let wanted = a.text(0)?;
        let database = a.database();
        let ids = database.ids().filter(|o| is_type(database, *o, &wanted));
        Ok(Value::Integer(ids.filter_map(|o| database.integer(o, "adams_id")).max().unwrap_or(0).saturating_add(1)))
    }),
    momentary("UNIQUE_LOCAL_NAME", "parent, base", "name that is free below a parent", |a| {
        let (parent, base) = (a.object(0)?, a.text(1)?);
        Ok(Value::Text(unique_below(a.database(), Some(parent), &base)))
    }),
    momentary(
        "UNIQUE_PARTIAL_NAME",
        "parent, type",
        "name that is free for a new object of a type below a parent",
        |a| {
            let (parent, wanted) = (a.object(0)?, a.text(1)?);
            Ok(Value::Text(unique_below(a.database(), Some(parent), &wanted.trim().to_ascii_uppercase())))
        },
    ),
    momentary("UNIQUE_NAME", "base", "name that no object has", |a| {
        let base = a.text(0)?;
        Ok(Value::Text(unique_anywhere(a.database(), &base)))
    }),
    momentary("UNIQUE_NAME_IN_HIERARCHY", "base", "name that no object has", |a| {
        let base = a.text(0)?;
        Ok(Value::Text(unique_anywhere(a.database(), &base)))
    }),
];

/// Objects of a name below another, level by level within each branch.
fn named_below<'d>(database: &'d Database, parent: ObjectId, name: &str) -> impl Iterator<Item = ObjectId> + 'd {
    let name = name.trim().to_string();
    let all = database.subtree(parent).into_iter().skip(1);
    all.filter(move |o| database.get(*o).is_some_and(|o| o.name.eq_ignore_ascii_case(&name)))
}

fn count(n: usize) -> Value {
    Value::Integer(n as i64)
}

/// Whether an object is of a type or class as DB_TYPE names it.
pub(super) fn is_type(database: &Database, object: ObjectId, wanted: &str) -> bool {
    let wanted = wanted.trim().to_ascii_lowercase();
    matches!(wanted.as_str(), "all" | "any" | "adams")
        || database
            .get(object)
            .is_some_and(|o| o.class.is(&wanted) || o.class.word.eq_ignore_ascii_case(&wanted.replace('_', " ")))
}

fn current(database: &Database, wanted: &str) -> Option<ObjectId> {
    database.current(wanted)
}

fn below(a: &Arguments, levels: usize) -> Outcome<Value> {
    let (root, wanted) = (a.object(0)?, a.text(1)?);
    let database = a.database();
    let mut found = Vec::new();
    let mut level = vec![root];
    for _ in 0..levels {
        level = level.iter().flat_map(|o| database.object(*o).children.iter().copied()).collect();
        if level.is_empty() {
            break;
        }
        found.extend(level.iter().copied().filter(|o| is_type(database, *o, &wanted)));
    }
    Ok(Value::Objects(found))
}

/// Whether a text names an object, or an attribute of one.
fn names_something(database: &Database, name: &str) -> bool {
    let steps = Steps::of(name.trim());
    let Ok(reached) = reach(database, &steps) else { return false };
    match &steps.names[reached.steps..] {
        [] => true,
        [one] => attribute(database, reached.object, one).is_some(),
        _ => false,
    }
}

fn of_type_exists(database: &Database, name: &str, wanted: &str) -> bool {
    let Some(found) = find_object(database, name) else { return false };
    let object = database.object(found);
    database.children_named(object.parent, &object.name).iter().any(|o| is_type(database, *o, wanted))
}

/// The shortest ending of the full name that means this object alone.
pub(crate) fn short_name(database: &Database, object: ObjectId) -> String {
    let full = database.full_name(object);
    let steps = Steps::of(&full);
    for range in steps.ranges.iter().rev() {
        let short = &full[range.start..];
        if find_object(database, short) == Some(object) {
            return short.to_string();
        }
    }
    full
}

fn unique_below(database: &Database, parent: Option<ObjectId>, base: &str) -> String {
    let mut n = 1_u64;
    loop {
        let name = format!("{base}_{n}");
        if database.children_named(parent, &name).is_empty() {
            return name;
        }
        n += 1;
    }
}

/// A name that no object of the database has.
fn unique_anywhere(database: &Database, base: &str) -> String {
    let start = format!("{base}_").to_ascii_lowercase();
    let taken: std::collections::HashSet<u64> = database
        .ids()
        .filter_map(|o| database.object(o).name.to_ascii_lowercase().strip_prefix(&start)?.parse().ok())
        .collect();
    let mut n = 1;
    while taken.contains(&n) {
        n += 1;
    }
    format!("{base}_{n}")
}
