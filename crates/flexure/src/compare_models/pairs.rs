//! Which object of one model is which of the other.

use std::collections::HashMap;

use model::{Database, ObjectId};

use super::cells::Comparison;

/// Objects that are taken for the same.
#[derive(Debug, Default)]
pub(super) struct Pairs {
    pub forward: HashMap<ObjectId, ObjectId>,
    pub backward: HashMap<ObjectId, ObjectId>,
}

/// How much of two objects must be equal for one to be the other under a new name.
const ALIKE: f64 = 0.75;
/// Beyond so many combinations only objects with the same number are compared.
const MOST_COMBINATIONS: usize = 250_000;

impl Pairs {
    /// Matches by name from the top down, then what is left over by content.
    pub fn of(comparison: &Comparison, a: ObjectId, b: ObjectId) -> Pairs {
        let mut pairs = Pairs::default();
        pairs.join(a, b);
        pairs.names_below(comparison, a, b);
        // A part that is recognised lets its children be recognised by name, and its markers what
        // refers to them: from the top down, until nothing more is found.
        while pairs.recognise(comparison, a) {}
        pairs
    }

    fn join(&mut self, a: ObjectId, b: ObjectId) {
        self.forward.insert(a, b);
        self.backward.insert(b, a);
    }

    /// Objects of the same class and name below two that are the same.
    fn names_below(&mut self, comparison: &Comparison, a: ObjectId, b: ObjectId) {
        let mut open = vec![(a, b)];
        while let Some((a, b)) = open.pop() {
            for &child in &comparison.a.object(a).children {
                let object = comparison.a.object(child);
                if !self.forward.contains_key(&child)
                    && let Some(other) = comparison.b.child(Some(b), &object.name, object.class.id)
                    && !self.backward.contains_key(&other)
                {
                    self.join(child, other);
                }
                if let Some(&other) = self.forward.get(&child) {
                    open.push((child, other));
                }
            }
        }
    }

    /// Finds objects under new names; false if there are none.
    fn recognise(&mut self, comparison: &Comparison, model: ObjectId) -> bool {
        let mut found = false;
        for parent in comparison.a.subtree(model) {
            let Some(&other) = self.forward.get(&parent) else { continue };
            let left_over = |database: &Database, parent: ObjectId, known: &HashMap<ObjectId, ObjectId>| {
                let children = &database.object(parent).children;
                children.iter().copied().filter(|c| !known.contains_key(c)).collect::<Vec<_>>()
            };
            let gone = left_over(comparison.a, parent, &self.forward);
            let new = left_over(comparison.b, other, &self.backward);
            let few = gone.len().saturating_mul(new.len()) <= MOST_COMBINATIONS;
            let mut candidates = Vec::new();
            for (i, &x) in gone.iter().enumerate() {
                for (j, &y) in new.iter().enumerate() {
                    if comparison.a.object(x).class.id != comparison.b.object(y).class.id
                        || !few && !same_number(comparison, x, y)
                    {
                        continue;
                    }
                    let score = self.likeness(comparison, x, y);
                    if score >= ALIKE {
                        candidates.push((score, i, j));
                    }
                }
            }
            // The most alike first; among equals, in order of creation.
            candidates.sort_by(|p, q| q.0.total_cmp(&p.0).then((p.1, p.2).cmp(&(q.1, q.2))));
            for (_, i, j) in candidates {
                let (x, y) = (gone[i], new[j]);
                if !self.forward.contains_key(&x) && !self.backward.contains_key(&y) {
                    self.join(x, y);
                    self.names_below(comparison, x, y);
                    found = true;
                }
            }
        }
        found
    }

    /// Share of the values and children of two objects that are equal.
    fn likeness(&self, comparison: &Comparison, a: ObjectId, b: ObjectId) -> f64 {
        let (mut equal, mut all) = comparison.likeness(a, b, self);
        let (x, y) = (comparison.a.object(a), comparison.b.object(b));
        for &child in &x.children {
            let object = comparison.a.object(child);
            all += 1.0;
            equal += f64::from(u8::from(comparison.b.child(Some(b), &object.name, object.class.id).is_some()));
        }
        all += y.children.len().saturating_sub(x.children.len()) as f64;
        if all == 0.0 { 0.0 } else { equal / all }
    }
}

fn same_number(comparison: &Comparison, a: ObjectId, b: ObjectId) -> bool {
    let number = |database: &Database, id| database.integer(id, "adams_id").filter(|n| *n != 0);
    let first = number(comparison.a, a);
    first.is_some() && first == number(comparison.b, b)
}
