//! Generated names and solver ids without searching the whole model each time.

use model::{Database, ObjectId};
use rustc_hash::FxHashMap;
use schema::Class;

/// What is known about names and ids in use. Only a memory: it is dropped whenever something may
/// have been taken back, and built anew from the database.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// Objects of a kind in a model, by model and word of the class.
    counts: FxHashMap<(Option<ObjectId>, &'static str), u64>,
    /// Objects by solver id.
    ids: FxHashMap<IdKey, ObjectId>,
    /// The highest solver id by model and word of the class: floating markers are counted apart from markers.
    highest: FxHashMap<(Option<ObjectId>, &'static str), i64>,
    ids_known: bool,
}

impl Names {
    /// Drops everything: after undo, deletion, renaming.
    pub fn forget(&mut self) {
        *self = Names::default();
    }

    /// Takes note of a new object.
    pub fn created(&mut self, database: &Database, id: ObjectId) {
        let scope = database.model_of(id).filter(|m| *m != id);
        if let Some(count) = self.counts.get_mut(&(scope, database.object(id).class.word)) {
            *count += 1;
        }
    }

    /// A free name: the prefix and the number the object has among those of its kind, which is also
    /// the id it would get; if that name is in use, with `_2`, `_3` behind it.
    pub fn generate(
        &mut self,
        database: &Database,
        class: &'static Class,
        parent: Option<ObjectId>,
        prefix: &str,
    ) -> String {
        let scope = parent.and_then(|p| database.model_of(p));
        let count = *self.counts.entry((scope, class.word)).or_insert_with(|| {
            let all: Vec<ObjectId> = scope.map_or_else(|| database.roots().to_vec(), |s| database.subtree(s));
            all.into_iter().filter(|id| Some(*id) != scope && database.object(*id).class.word == class.word).count()
                as u64
        });
        self.know_ids(database);
        let highest = self.highest.get(&(scope, class.word));
        let highest = highest.map_or(0, |id| u64::try_from(*id).unwrap_or(0));
        let name = format!("{prefix}{}", count.max(highest) + 1);
        // Another class may use the name below the same parent; that is no clash, but confusing.
        let mut free = name.clone();
        let mut extra = 2;
        while !database.children_named(parent, &free).is_empty() {
            free = format!("{name}_{extra}");
            extra += 1;
        }
        free
    }

    fn know_ids(&mut self, database: &Database) {
        if self.ids_known {
            return;
        }
        self.ids_known = true;
        for other in database.ids() {
            if let Some(n) = database.integer(other, "adams_id").filter(|n| *n != 0) {
                let key = id_key(database, other, n);
                let highest = self.highest.entry((key.0, database.object(other).class.word)).or_default();
                *highest = n.max(*highest);
                self.ids.entry(key).or_insert(other);
            }
        }
    }

    /// The object other than `id` that has a solver id among objects of the same statement, and
    /// notes that `id` has it now.
    pub fn holder_of_id(&mut self, database: &Database, id: ObjectId, number: i64) -> Option<ObjectId> {
        if number == 0 {
            return None;
        }
        self.know_ids(database);
        let key = id_key(database, id, number);
        let highest = self.highest.entry((key.0, database.object(id).class.word)).or_default();
        *highest = number.max(*highest);
        let noted = self.ids.entry(key).or_insert(id);
        let held =
            *noted != id && database.get(*noted).is_some() && database.integer(*noted, "adams_id") == Some(number);
        if held {
            return Some(*noted);
        }
        *noted = id;
        None
    }
}

/// A solver id with the model and the statement within which it is unique.
type IdKey = (Option<ObjectId>, &'static str, i64);

/// Ids are unique per statement of the solver; classes without one are apart from each other.
fn id_key(database: &Database, id: ObjectId, number: i64) -> IdKey {
    let class = database.object(id).class;
    (database.model_of(id), class.statement.unwrap_or(class.id), number)
}
