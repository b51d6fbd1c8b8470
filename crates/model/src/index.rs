//! The index of names: which objects below a parent have a name.

use std::hash::Hasher;

use hashbrown::{HashTable, hash_table::Entry};
use rustc_hash::FxHasher;
use smallvec::SmallVec;

use crate::{Object, ObjectId};

/// Objects as the database keeps them, by handle.
type Arena = [Option<Box<Object>>];

/// Objects of different classes that share a parent and a name.
#[derive(Clone, Debug)]
struct Namesakes {
    /// Of the parent and the name.
    hash: u64,
    objects: SmallVec<[ObjectId; 2]>,
}

/// Objects by parent and name, ignoring case. The names themselves stay in the objects: an entry is
/// found by its hash and compared with the name of the first object that it lists.
#[derive(Clone, Debug, Default)]
pub(crate) struct NameIndex {
    entries: HashTable<Namesakes>,
}

impl NameIndex {
    /// Objects below a parent (or at the top) that have a name, in the order in which they got it.
    pub fn find(&self, arena: &Arena, parent: Option<ObjectId>, name: &str) -> &[ObjectId] {
        let hash = hash(parent, name);
        let found = self.entries.find(hash, |entry| entry.is(arena, hash, parent, name));
        found.map_or(&[], |entry| entry.objects.as_slice())
    }

    /// Takes up an object under the name and parent that it has.
    pub fn insert(&mut self, arena: &Arena, id: ObjectId) {
        let Some((parent, name)) = name_of(arena, id) else { return };
        let hash = hash(parent, name);
        match self.entries.entry(hash, |entry| entry.is(arena, hash, parent, name), |entry| entry.hash) {
            Entry::Occupied(mut entry) => entry.get_mut().objects.push(id),
            Entry::Vacant(entry) => {
                entry.insert(Namesakes { hash, objects: SmallVec::from_slice(&[id]) });
            }
        }
    }

    /// Drops an object that still has the name and parent under which it was taken up.
    pub fn remove(&mut self, arena: &Arena, id: ObjectId) {
        let Some((parent, name)) = name_of(arena, id) else { return };
        let hash = hash(parent, name);
        if let Ok(mut entry) = self.entries.find_entry(hash, |entry| entry.is(arena, hash, parent, name)) {
            entry.get_mut().objects.retain(|other| *other != id);
            if entry.get().objects.is_empty() {
                entry.remove();
            }
        }
    }
}

fn name_of(arena: &Arena, id: ObjectId) -> Option<(Option<ObjectId>, &str)> {
    let object = arena.get(id.0 as usize)?.as_ref()?;
    Some((object.parent, &object.name))
}

impl Namesakes {
    fn is(&self, arena: &Arena, hash: u64, parent: Option<ObjectId>, name: &str) -> bool {
        let first = || self.objects.first().and_then(|id| name_of(arena, *id));
        self.hash == hash && first().is_some_and(|(p, n)| p == parent && n.eq_ignore_ascii_case(name))
    }
}

fn hash(parent: Option<ObjectId>, name: &str) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write_u32(parent.map_or(u32::MAX, |p| p.0));
    for byte in name.bytes() {
        hasher.write_u8(byte.to_ascii_lowercase());
    }
    hasher.finish()
}
