//! The index of names: which objects have a name, below a parent or anywhere.

use std::hash::Hasher;

use hashbrown::{HashTable, hash_table::Entry};
use rustc_hash::FxHasher;
use smallvec::SmallVec;

use crate::{Object, ObjectId};

/// Objects as the database keeps them, by handle.
type Arena = [Option<Box<Object>>];

/// Objects that share a name: those below one parent, or all.
#[derive(Clone, Debug)]
struct Namesakes {
    /// Of the name, and of the parent where it counts.
    hash: u64,
    objects: SmallVec<[ObjectId; 2]>,
}

/// Objects by name, ignoring case. The names themselves stay in the objects: an entry is found by
/// its hash and compared with the name of the first object that it lists.
#[derive(Clone, Debug, Default)]
pub(crate) struct NameIndex {
    below_parent: HashTable<Namesakes>,
    anywhere: HashTable<Namesakes>,
}

impl NameIndex {
    /// Objects below a parent (or at the top) that have a name, in the order in which they got it.
    pub fn find(&self, arena: &Arena, parent: Option<ObjectId>, name: &str) -> &[ObjectId] {
        objects(&self.below_parent, arena, Key::below(parent, name))
    }

    /// All objects that have a name, wherever they are.
    pub fn find_anywhere(&self, arena: &Arena, name: &str) -> &[ObjectId] {
        objects(&self.anywhere, arena, Key::anywhere(name))
    }

    /// Takes up an object under the name and parent that it has.
    pub fn insert(&mut self, arena: &Arena, id: ObjectId) {
        let Some((parent, name)) = name_of(arena, id) else { return };
        insert(&mut self.below_parent, arena, Key::below(parent, name), id);
        insert(&mut self.anywhere, arena, Key::anywhere(name), id);
    }

    /// Drops an object that still has the name and parent under which it was taken up.
    pub fn remove(&mut self, arena: &Arena, id: ObjectId) {
        let Some((parent, name)) = name_of(arena, id) else { return };
        remove(&mut self.below_parent, arena, Key::below(parent, name), id);
        remove(&mut self.anywhere, arena, Key::anywhere(name), id);
    }
}

/// Where the objects of an entry are.
#[derive(Clone, Copy)]
enum Place {
    Anywhere,
    /// Below a parent, or at the top.
    Below(Option<ObjectId>),
}

/// What an entry is looked up by.
#[derive(Clone, Copy)]
struct Key<'a> {
    hash: u64,
    place: Place,
    name: &'a str,
}

impl<'a> Key<'a> {
    fn below(parent: Option<ObjectId>, name: &'a str) -> Key<'a> {
        Key { hash: hash(parent, name), place: Place::Below(parent), name }
    }

    fn anywhere(name: &'a str) -> Key<'a> {
        Key { hash: hash(None, name), place: Place::Anywhere, name }
    }

    fn fits(&self, arena: &Arena, entry: &Namesakes) -> bool {
        let first = || entry.objects.first().and_then(|id| name_of(arena, *id));
        let same = |(parent, name): (Option<ObjectId>, &str)| {
            let here = match self.place {
                Place::Anywhere => true,
                Place::Below(wanted) => parent == wanted,
            };
            here && name.eq_ignore_ascii_case(self.name)
        };
        self.hash == entry.hash && first().is_some_and(same)
    }
}

fn objects<'t>(table: &'t HashTable<Namesakes>, arena: &Arena, key: Key) -> &'t [ObjectId] {
    table.find(key.hash, |entry| key.fits(arena, entry)).map_or(&[], |entry| entry.objects.as_slice())
}

fn insert(table: &mut HashTable<Namesakes>, arena: &Arena, key: Key, id: ObjectId) {
    match table.entry(key.hash, |entry| key.fits(arena, entry), |entry| entry.hash) {
        Entry::Occupied(mut entry) => entry.get_mut().objects.push(id),
        Entry::Vacant(entry) => {
            entry.insert(Namesakes { hash: key.hash, objects: SmallVec::from_slice(&[id]) });
        }
    }
}

fn remove(table: &mut HashTable<Namesakes>, arena: &Arena, key: Key, id: ObjectId) {
    if let Ok(mut entry) = table.find_entry(key.hash, |entry| key.fits(arena, entry)) {
        // Mostly the newest goes first.
        let objects = &mut entry.get_mut().objects;
        if let Some(place) = objects.iter().rposition(|other| *other == id) {
            objects.remove(place);
        }
        if entry.get().objects.is_empty() {
            entry.remove();
        }
    }
}

fn name_of(arena: &Arena, id: ObjectId) -> Option<(Option<ObjectId>, &str)> {
    let object = arena.get(id.0 as usize)?.as_ref()?;
    Some((object.parent, &object.name))
}

fn hash(parent: Option<ObjectId>, name: &str) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write_u32(parent.map_or(u32::MAX, |p| p.0));
    for byte in name.bytes() {
        hasher.write_u8(byte.to_ascii_lowercase());
    }
    hasher.finish()
}
