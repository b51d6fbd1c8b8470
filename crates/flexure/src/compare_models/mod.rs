//! What is different between two models: objects that came, went or got another name, and values.
//!
//! Objects are matched by name from the top down; what is left over on both sides is matched by
//! content ([`pairs`]). References are compared by what they refer to, so a new name is told once and
//! not at every place that uses it. Numbers are compared in SI ([`cells`]).

mod cells;
mod pairs;

use std::collections::{BTreeMap, HashSet};

use model::{Database, ObjectId};

use cells::Comparison;
use pairs::Pairs;

/// One difference. Names of objects are full names: of the second model where they exist there.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelChange {
    /// With how many objects below it.
    Removed {
        class: &'static str,
        name: String,
        below: usize,
    },
    Added {
        class: &'static str,
        name: String,
        below: usize,
    },
    Renamed {
        class: &'static str,
        from: String,
        to: String,
    },
    Value(ValueChange),
    /// A command that is kept without being executed is in one model only.
    Command {
        text: String,
        added: bool,
    },
}

/// A value that differs, as text with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueChange {
    pub class: &'static str,
    pub name: String,
    pub attribute: &'static str,
    /// None: unset.
    pub before: Option<String>,
    pub after: Option<String>,
    pub why: Why,
}

/// How a value came to differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// It was given otherwise.
    Given,
    /// The value is the same, but it is computed in another way.
    SameValue,
    /// The same expression yields another value, because of another difference.
    SameExpression,
}

/// All differences, in an order that depends on nothing but the two models.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelDifferences {
    pub changes: Vec<ModelChange>,
    /// What a reader should know, but is no difference.
    pub notes: Vec<String>,
}

impl ModelDifferences {
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }
}

/// One side of a comparison.
#[derive(Clone, Copy)]
pub(crate) struct Side<'a> {
    pub database: &'a Database,
    pub model: ObjectId,
    /// Commands of the model that are kept as text.
    pub kept: &'a [String],
}

/// Compares two models; `tolerance` is relative to the size of a value.
pub(crate) fn compare_models(a: Side, b: Side, tolerance: f64) -> ModelDifferences {
    let comparison = Comparison { a: a.database, b: b.database, tolerance };
    let pairs = Pairs::of(&comparison, a.model, b.model);
    let removed = |class, name, below| ModelChange::Removed { class, name, below };
    let mut removed = one_sided(a, |id| pairs.forward.contains_key(&id), removed);
    let added = |class, name, below| ModelChange::Added { class, name, below };
    let mut added = one_sided(b, |id| pairs.backward.contains_key(&id), added);
    let mut renamed = Vec::new();
    let mut values = Vec::new();
    for id in a.database.subtree(a.model) {
        let Some(&other) = pairs.forward.get(&id) else { continue };
        let (x, y) = (a.database.object(id), b.database.object(other));
        if x.name != y.name {
            let (from, to) = (a.database.full_name(id), b.database.full_name(other));
            renamed.push((to.clone(), ModelChange::Renamed { class: y.class.word, from, to }));
        }
        let name = b.database.full_name(other);
        for change in comparison.changes(id, other, &pairs) {
            values.push((name.clone(), ModelChange::Value(ValueChange { name: name.clone(), ..change })));
        }
    }
    let mut changes = Vec::new();
    for list in [&mut removed, &mut added, &mut renamed, &mut values] {
        list.sort_by(|p, q| p.0.cmp(&q.0)); // stable: values of one object keep the order of its class
        changes.extend(list.drain(..).map(|(_, change)| change));
    }
    changes.extend(commands(a.kept, b.kept));
    ModelDifferences { changes, notes: notes(a, b) }
}

/// The topmost objects that have no counterpart.
fn one_sided(
    side: Side,
    paired: impl Fn(ObjectId) -> bool,
    change: impl Fn(&'static str, String, usize) -> ModelChange,
) -> Vec<(String, ModelChange)> {
    let mut inside: HashSet<ObjectId> = HashSet::new();
    let mut found = Vec::new();
    for id in side.database.subtree(side.model) {
        if paired(id) {
            continue;
        }
        inside.insert(id);
        let object = side.database.object(id);
        if object.parent.is_some_and(|p| inside.contains(&p)) {
            continue;
        }
        let (class, name) = (object.class.word, side.database.full_name(id));
        let below = side.database.subtree(id).len() - 1;
        found.push((name.clone(), change(class, name, below)));
    }
    found
}

/// Commands that are kept as text, regardless of layout and order.
fn commands(a: &[String], b: &[String]) -> Vec<ModelChange> {
    let mut count: BTreeMap<String, i64> = BTreeMap::new();
    for (list, sign) in [(a, -1), (b, 1)] {
        for text in list {
            let words: Vec<&str> = text.split_whitespace().filter(|w| *w != "&").collect();
            *count.entry(words.join(" ")).or_default() += sign;
        }
    }
    let all = count.into_iter().filter(|(_, n)| *n != 0);
    all.map(|(text, n)| ModelChange::Command { text, added: n > 0 }).collect()
}

fn notes(a: Side, b: Side) -> Vec<String> {
    let units = |side: Side| {
        let u = side.database.units();
        [u.length.name, u.mass.name, u.force.name, u.time.name, u.angle.name].join(", ")
    };
    let (before, after) = (units(a), units(b));
    if before == after {
        return Vec::new();
    }
    vec![format!(
        "the first model is in {before}, the second in {after}: values are compared in the same units, run-time \
         functions and plain variables as they are written"
    )]
}
