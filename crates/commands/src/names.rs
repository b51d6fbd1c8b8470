//! Generated names and solver ids without searching the whole model each time.

use model::{Database, ObjectId};
use rustc_hash::FxHashMap;
use schema::Class;

/// What is known about names and ids in use. Only a memory: it is dropped whenever something may
/// have been taken back, and built anew from the database.
#[derive(Debug, Default)]
pub struct Names {
    /// Highest number behind a prefix, by model, word of the class and prefix.
    highest: FxHashMap<(Option<ObjectId>, &'static str, String), u64>,
    /// Objects by solver id.
    ids: FxHashMap<IdKey, ObjectId>,
    ids_known: bool,
}

impl Names {
    /// Drops everything: after undo, deletion, renaming.
    pub fn forget(&mut self) {
        *self = Names::default();
    }

    /// Takes note of a new object.
    pub fn created(&mut self, database: &Database, id: ObjectId) {
        let object = database.object(id);
        let scope = database.model_of(id).filter(|m| *m != id);
        let digits = object.name.bytes().rev().take_while(u8::is_ascii_digit).count();
        let (prefix, number) = object.name.split_at(object.name.len() - digits);
        if let Ok(number) = number.parse::<u64>() {
            let key = (scope, object.class.word, prefix.to_ascii_lowercase());
            if let Some(highest) = self.highest.get_mut(&key) {
                *highest = number.max(*highest);
            }
        }
    }

    /// A free name: the prefix and the number above all in use.
    pub fn generate(
        &mut self,
        database: &Database,
        class: &'static Class,
        parent: Option<ObjectId>,
        prefix: &str,
    ) -> String {
        let scope = parent.and_then(|p| database.model_of(p));
        let key = (scope, class.word, prefix.to_ascii_lowercase());
        let number = if let Some(highest) = self.highest.get(&key) {
            highest + 1
        } else {
            let name = database.generated_name(class, parent, prefix);
            name.get(prefix.len()..).and_then(|n| n.parse().ok()).unwrap_or(1)
        };
        self.highest.insert(key, number);
        let name = format!("{prefix}{number}");
        // Another class may use the name below the same parent; that is no clash, but confusing.
        let mut free = name.clone();
        let mut extra = 2;
        while !database.children_named(parent, &free).is_empty() {
            free = format!("{name}_{extra}");
            extra += 1;
        }
        free
    }

    /// The object other than `id` that has a solver id among objects of the same statement, and
    /// notes that `id` has it now.
    pub fn holder_of_id(&mut self, database: &Database, id: ObjectId, number: i64) -> Option<ObjectId> {
        if number == 0 {
            return None;
        }
        if !self.ids_known {
            self.ids_known = true;
            for other in database.ids() {
                if let Some(n) = database.integer(other, "adams_id").filter(|n| *n != 0) {
                    self.ids.entry(id_key(database, other, n)).or_insert(other);
                }
            }
        }
        let noted = self.ids.entry(id_key(database, id, number)).or_insert(id);
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
