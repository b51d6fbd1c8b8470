//! Full names, how names are looked up, and generated names.

use std::borrow::Cow;

use schema::Class;
use smallvec::SmallVec;

use crate::{Database, ObjectId};

impl Database {
    /// Full name with a leading dot; names that need quotes are quoted.
    pub fn full_name(&self, id: ObjectId) -> String {
        let above = |id: &ObjectId| self.get(*id)?.parent;
        let path: SmallVec<[ObjectId; 8]> = std::iter::successors(Some(id), above).collect();
        let mut name = String::new();
        for object in path.iter().rev().filter_map(|id| self.get(*id)) {
            name.push('.');
            push_quoted(&mut name, &object.name);
        }
        if name.is_empty() { ".".into() } else { name }
    }

    /// Children of a parent (or top-level objects) with a name, ignoring case.
    pub fn children_named(&self, parent: Option<ObjectId>, name: &str) -> &[ObjectId] {
        self.names.find(&self.objects, parent, name)
    }

    /// All objects with a name, wherever they are, ignoring case.
    pub fn named(&self, name: &str) -> &[ObjectId] {
        self.names.find_anywhere(&self.objects, name)
    }

    /// Objects below `root`, itself left out, that have a child with a name: with their depth below
    /// it, nearest first, then in order of creation.
    pub fn holders_of_name(&self, root: ObjectId, name: &str) -> Vec<(usize, ObjectId)> {
        let parents = self.named(name).iter().filter_map(|id| self.object(*id).parent);
        let mut found: Vec<_> = parents.filter_map(|p| Some((self.depth_below(p, root)?, p))).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// How many steps below another an object is; none for that object and for one elsewhere.
    fn depth_below(&self, id: ObjectId, root: ObjectId) -> Option<usize> {
        let parent = |id: &ObjectId| self.object(*id).parent;
        std::iter::successors(Some(id), parent).position(|id| id == root).filter(|depth| *depth > 0)
    }

    /// A child of a parent with a name that is of the wanted class or family.
    pub fn child(&self, parent: Option<ObjectId>, name: &str, wanted: &str) -> Option<ObjectId> {
        self.children_named(parent, name).iter().copied().find(|&c| self.object(c).class.is(wanted))
    }

    /// A child of the kind that would clash with a new object of `class`: same word in messages.
    pub fn child_of_kind(&self, parent: Option<ObjectId>, name: &str, class: &Class) -> Option<ObjectId> {
        self.children_named(parent, name).iter().copied().find(|&c| self.object(c).class.word == class.word)
    }

    /// Finds an existing object by full name (`.model.part.marker`). Only the last step must be of
    /// the wanted class or family.
    pub fn find(&self, full_name: &str, wanted: &str) -> Option<ObjectId> {
        self.descend(None, &name_steps(full_name.strip_prefix('.')?), wanted)
    }

    /// Follows name steps down from a parent, trying every object that shares a step's name.
    pub fn descend<S: AsRef<str>>(&self, from: Option<ObjectId>, steps: &[S], wanted: &str) -> Option<ObjectId> {
        self.descend_to(from, steps, &|class| class.is(wanted))
    }

    /// As [`Database::descend`], to an object of a class that fits.
    pub fn descend_to<S: AsRef<str>>(
        &self,
        from: Option<ObjectId>,
        steps: &[S],
        fits: &dyn Fn(&Class) -> bool,
    ) -> Option<ObjectId> {
        let (first, rest) = steps.split_first()?;
        let named = self.children_named(from, first.as_ref());
        if rest.is_empty() {
            return named.iter().copied().find(|&c| fits(self.object(c).class));
        }
        named.iter().find_map(|&c| self.descend_to(Some(c), rest, fits))
    }

    /// The model an object belongs to.
    pub fn model_of(&self, id: ObjectId) -> Option<ObjectId> {
        let mut next = Some(id);
        while let Some(object) = next {
            if self.object(object).class.id == "model" {
                return Some(object);
            }
            next = self.object(object).parent;
        }
        None
    }

    /// A free generated name for a class below a parent: the class prefix and the smallest number
    /// above those in use.
    pub fn generated_name(&self, class: &Class, parent: Option<ObjectId>, prefix: &str) -> String {
        let scope = parent.and_then(|p| self.model_of(p)).or(parent);
        let used = match scope {
            Some(scope) => self.subtree(scope),
            None => self.roots.clone(),
        };
        let highest = used
            .into_iter()
            .filter_map(|id| {
                let object = self.object(id);
                if object.class.word != class.word {
                    return None;
                }
                let name = object.name.as_str();
                let head = name.get(..prefix.len())?;
                if !head.eq_ignore_ascii_case(prefix) {
                    return None;
                }
                name[prefix.len()..].parse::<u64>().ok()
            })
            .max()
            .unwrap_or(u64::from(class.word == "Part"));
        format!("{prefix}{}", highest + 1)
    }
}

/// A name as it must be typed: quoted when it is not letters, digits and underscores or starts
/// with a digit.
pub fn quoted(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    push_quoted(&mut text, name);
    text
}

fn push_quoted(text: &mut String, name: &str) {
    let plain = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && name.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'_');
    let quote = if plain { "" } else { "\"" };
    text.extend([quote, name, quote]);
}

/// Splits `part."odd name".marker` at the dots outside quotes and removes the quotes.
pub fn split_name(name: &str) -> Vec<String> {
    name_steps(name).into_iter().map(Cow::into_owned).collect()
}

/// The steps of [`split_name`], borrowed where there are no quotes.
pub fn name_steps(name: &str) -> SmallVec<[Cow<'_, str>; 4]> {
    if !name.contains('"') {
        return name.split('.').map(Cow::Borrowed).collect();
    }
    let (mut steps, mut step, mut inside) = (SmallVec::new(), String::new(), false);
    for c in name.chars() {
        match c {
            '"' => inside = !inside,
            '.' if !inside => steps.push(Cow::Owned(std::mem::take(&mut step))),
            _ => step.push(c),
        }
    }
    steps.push(Cow::Owned(step));
    steps
}
