//! Which object a name means: full names from the root, partial names from the default model and
//! the default part, short names that are unique below the default model.

use std::ops::Range;

use model::{Database, ObjectId, Value, split_name};

use crate::{
    Scope,
    scope::{Outcome, problem},
};

/// A dotted name taken apart, with the place of each step in the text.
pub(crate) struct Steps {
    /// Starts with a dot: a full name.
    pub absolute: bool,
    pub names: Vec<String>,
    pub ranges: Vec<Range<usize>>,
}

impl Steps {
    pub fn of(name: &str) -> Steps {
        let absolute = name.starts_with('.');
        let start = usize::from(absolute);
        let body = name.get(start..).unwrap_or("");
        let (mut ranges, mut from, mut inside) = (Vec::new(), 0, false);
        for (i, c) in body.char_indices() {
            match c {
                '"' => inside = !inside,
                '.' if !inside => {
                    ranges.push(start + from..start + i);
                    from = i + 1;
                }
                _ => {}
            }
        }
        ranges.push(start + from..start + body.len());
        Steps { absolute, names: split_name(body), ranges }
    }
}

/// The deepest object a name reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reached {
    pub object: ObjectId,
    /// How many steps led to it; the others are attributes or wrong.
    pub steps: usize,
}

/// Why a name means no object.
pub(crate) enum Unknown {
    /// Not even the first step is known.
    Nothing,
    /// A short name that several objects have.
    Ambiguous(Vec<ObjectId>),
}

/// Follows steps down from a parent as far as they lead. Where objects share a name, the one that
/// leads furthest counts; among equals, one that has the next step as an attribute.
fn descend(database: &Database, from: Option<ObjectId>, names: &[String], used: usize) -> Option<Reached> {
    let first = names.get(used)?;
    let mut best: Option<(Reached, bool)> = None;
    for &child in database.children_named(from, first) {
        let here = Reached { object: child, steps: used + 1 };
        let deepest = descend(database, Some(child), names, used + 1).unwrap_or(here);
        let fits =
            names.get(deepest.steps).is_none_or(|n| crate::attributes::is_attribute(database, deepest.object, n));
        let better = best.is_none_or(|(b, fit)| (fits, deepest.steps) > (fit, b.steps));
        if better {
            best = Some((deepest, fits));
        }
    }
    best.map(|(reached, _)| reached)
}

/// Finds what the steps of a name mean.
pub(crate) fn reach(database: &Database, steps: &Steps) -> Result<Reached, Unknown> {
    if steps.absolute {
        return descend(database, None, &steps.names, 0).ok_or(Unknown::Nothing);
    }
    let model = database.current("model");
    let part = database.current("part").or_else(|| database.current("body"));
    for base in [model, part].into_iter().flatten() {
        if let Some(reached) = descend(database, Some(base), &steps.names, 0) {
            return Ok(reached);
        }
    }
    if let Some(model) = model {
        let found = below(database, model, &steps.names);
        match found.as_slice() {
            [] => {}
            [one] => return Ok(*one),
            several => return Err(Unknown::Ambiguous(several.iter().map(|r| r.object).collect())),
        }
    }
    descend(database, None, &steps.names, 0).ok_or(Unknown::Nothing)
}

/// Every place below the children of a model where the steps of a short name begin, level by level:
/// the first level that has any counts.
fn below(database: &Database, model: ObjectId, names: &[String]) -> Vec<Reached> {
    let Some(first) = names.first() else { return Vec::new() };
    let holders = database.holders_of_name(model, first);
    let Some(&(nearest, _)) = holders.first() else { return Vec::new() };
    let level = holders.into_iter().take_while(|(depth, _)| *depth == nearest);
    level.filter_map(|(_, holder)| descend(database, Some(holder), names, 0)).collect()
}

/// The existing object a name means: full, partial or short.
pub fn find_object(database: &Database, name: &str) -> Option<ObjectId> {
    let steps = Steps::of(name.trim());
    let reached = reach(database, &steps).ok()?;
    (reached.steps == steps.names.len()).then_some(reached.object)
}

/// The object a value means: an object, or a text that names one.
pub fn object_of(value: &Value, scope: &Scope) -> Option<ObjectId> {
    match value {
        Value::Text(name) => find_object(scope.database, name),
        other => other.as_object().filter(|o| scope.database.get(*o).is_some()),
    }
}

/// As [`object_of`], with the reason if there is none.
pub(crate) fn object_or_problem(value: &Value, scope: &Scope) -> Outcome<ObjectId> {
    object_of(value, scope).ok_or_else(|| match value {
        Value::Text(name) => problem("expression/no-such-object", format!("no object is named `{name}`"))
            .adams(format!("No object named '{name}' was found."))
            .into(),
        Value::Nothing => problem("expression/no-object", "an object is needed here, not (none)"),
        other => problem(
            "expression/not-an-object",
            format!("an object is needed here, not {}", crate::evaluate::describe(other)),
        ),
    })
}

/// The candidate nearest to a misspelled word, if one is near enough to be meant.
pub(crate) fn nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_ascii_lowercase();
    let limit = (word.chars().count() / 3).max(1);
    candidates
        .map(|c| (distance(&word, &c.to_ascii_lowercase()), c))
        .filter(|(d, _)| *d <= limit)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

/// Number of insertions, deletions and replacements between two words.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replace = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
