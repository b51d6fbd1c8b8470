//! The arena of objects and the only methods that change it.

use std::collections::BTreeSet;

use schema::{Class, Dimension, Field, Quantity, UnitSystem};
use serde::{Deserialize, Serialize};
use smallvec::SmallVec;

use crate::{
    Cell, CellKey, Cells, Mark, Settings, UnitsId, Value,
    dependencies::Dependencies,
    index::NameIndex,
    settings::first_units,
    undo::{Change, History, Place},
};

/// Handle of an object; never used again after the object is deleted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ObjectId(pub u32);

/// One object of the tree.
#[derive(Clone, Debug)]
pub struct Object {
    pub class: &'static Class,
    /// Name in the case it was given.
    pub name: String,
    pub parent: Option<ObjectId>,
    /// In order of creation.
    pub children: Vec<ObjectId>,
    pub cells: Cells,
}

/// An object of that kind and full name exists already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NameTaken(pub ObjectId);

/// The modelling database.
#[derive(Clone, Debug)]
pub struct Database {
    pub(crate) objects: Vec<Option<Box<Object>>>,
    /// Top-level objects in order of creation.
    pub(crate) roots: Vec<ObjectId>,
    pub(crate) names: NameIndex,
    pub(crate) settings: Settings,
    pub(crate) unit_systems: Vec<UnitSystem>,
    pub(crate) dependencies: Dependencies,
    pub(crate) history: History,
    /// Counts changes of objects; settings are not counted.
    pub(crate) revision: u64,
    /// Objects changed since somebody began to watch, for a file that follows the session.
    pub(crate) touched: Option<BTreeSet<ObjectId>>,
}

impl Default for Database {
    fn default() -> Self {
        Database {
            objects: Vec::new(),
            roots: Vec::new(),
            names: NameIndex::default(),
            settings: Settings::default(),
            unit_systems: vec![first_units()],
            dependencies: Dependencies::default(),
            history: History::default(),
            revision: 0,
            touched: None,
        }
    }
}

impl Database {
    // ---- reading ----

    /// The object of a handle that is known to live.
    ///
    /// # Panics
    /// If the object was deleted, which only a mistake in Flexure can bring about.
    pub fn object(&self, id: ObjectId) -> &Object {
        self.get(id).expect("handle of a living object")
    }

    /// The object of a handle, if it still lives.
    pub fn get(&self, id: ObjectId) -> Option<&Object> {
        self.objects.get(id.0 as usize)?.as_deref()
    }

    /// Top-level objects in order of creation.
    pub fn roots(&self) -> &[ObjectId] {
        &self.roots
    }

    /// All living objects in order of creation.
    pub fn ids(&self) -> impl Iterator<Item = ObjectId> + '_ {
        self.objects.iter().enumerate().filter(|(_, o)| o.is_some()).map(|(i, _)| ObjectId(i as u32))
    }

    /// An object and everything below it, parents first, in order of creation.
    pub fn subtree(&self, id: ObjectId) -> Vec<ObjectId> {
        let mut found = vec![id];
        let mut next = 0;
        while next < found.len() {
            found.extend(&self.object(found[next]).children);
            next += 1;
        }
        found
    }

    /// Everything below `root` of a class or family, in order of creation of parents.
    pub fn below(&self, root: ObjectId, wanted: &str) -> Vec<ObjectId> {
        let mut found = self.subtree(root);
        found.retain(|&id| id != root && self.object(id).class.is(wanted));
        found
    }

    /// A number that differs after any object changed, also by undo.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The units in force.
    pub fn units(&self) -> &UnitSystem {
        &self.unit_systems[self.settings.units.0 as usize]
    }

    pub fn unit_system(&self, id: UnitsId) -> &UnitSystem {
        &self.unit_systems[id.0 as usize]
    }

    /// Current default object of a class id or family.
    pub fn current(&self, wanted: &str) -> Option<ObjectId> {
        self.settings.current.get(wanted).copied().filter(|id| self.get(*id).is_some())
    }

    /// A cell by field name; `None` if unset or no such field.
    pub fn cell(&self, id: ObjectId, name: &str) -> Option<&Cell> {
        let object = self.object(id);
        object.cells.get(object.class.cell_index(name)?)
    }

    pub fn value(&self, id: ObjectId, name: &str) -> Option<&Value> {
        self.cell(id, name).map(|c| &c.value)
    }

    /// The field of a cell with the dimension that it has in this object.
    pub fn field(&self, id: ObjectId, index: usize) -> Field {
        let mut field = *self.object(id).class.field(index);
        field.dimension = self.dimension(id, &field);
        field
    }

    /// What a field of an object measures.
    pub fn dimension(&self, id: ObjectId, field: &Field) -> Dimension {
        let named = field.quantity_in.and_then(|units| Quantity::named(self.text(id, units)?));
        named.map_or(field.dimension, |quantity| quantity.dimension)
    }

    /// A number in the units in force.
    pub fn number(&self, id: ObjectId, name: &str) -> Option<f64> {
        let object = self.object(id);
        let index = object.class.cell_index(name)?;
        let cell = object.cells.get(index)?;
        let x = cell.value.as_number()?;
        Some(x * self.ratio(cell.units, self.dimension(id, object.class.field(index))))
    }

    /// Numbers in the units in force.
    pub fn numbers(&self, id: ObjectId, name: &str) -> Option<Vec<f64>> {
        let object = self.object(id);
        let index = object.class.cell_index(name)?;
        let cell = object.cells.get(index)?;
        let ratio = self.ratio(cell.units, self.dimension(id, object.class.field(index)));
        let mut numbers = cell.value.as_numbers()?;
        if ratio != 1.0 {
            for x in &mut numbers {
                *x *= ratio;
            }
        }
        Some(numbers)
    }

    /// The first three numbers of an array in the units in force.
    pub(crate) fn triple(&self, id: ObjectId, name: &str) -> Option<[f64; 3]> {
        let object = self.object(id);
        let index = object.class.cell_index(name)?;
        let cell = object.cells.get(index)?;
        let ratio = self.ratio(cell.units, self.dimension(id, object.class.field(index)));
        cell.value.numbers().first_chunk::<3>().map(|v| v.map(|x| x * ratio))
    }

    /// A number in SI (force in newton, angles in radians).
    pub fn si(&self, id: ObjectId, name: &str) -> Option<f64> {
        let index = self.object(id).class.cell_index(name)?;
        let dimension = self.field(id, index).dimension;
        Some(self.number(id, name)? * self.units().factor(dimension))
    }

    /// Numbers in SI.
    pub fn si_numbers(&self, id: ObjectId, name: &str) -> Option<Vec<f64>> {
        let index = self.object(id).class.cell_index(name)?;
        let factor = self.units().factor(self.field(id, index).dimension);
        Some(self.numbers(id, name)?.into_iter().map(|x| x * factor).collect())
    }

    pub fn text(&self, id: ObjectId, name: &str) -> Option<&str> {
        self.value(id, name)?.as_text()
    }

    pub fn flag(&self, id: ObjectId, name: &str) -> Option<bool> {
        match self.value(id, name)? {
            Value::Flag(flag) => Some(*flag),
            other => other.as_number().map(|x| x != 0.0),
        }
    }

    pub fn integer(&self, id: ObjectId, name: &str) -> Option<i64> {
        self.value(id, name)?.as_number().map(|x| x as i64)
    }

    /// The object a cell refers to, if it still lives.
    pub fn reference(&self, id: ObjectId, name: &str) -> Option<ObjectId> {
        self.value(id, name)?.as_object().filter(|o| self.get(*o).is_some())
    }

    /// Factor from entered units to the units in force; exactly 1 when they are the same.
    pub fn ratio(&self, entered: UnitsId, dimension: Dimension) -> f64 {
        if entered == self.settings.units || dimension == Dimension::NONE {
            1.0
        } else {
            self.unit_system(entered).factor(dimension) / self.units().factor(dimension)
        }
    }

    // ---- changing; every method records its inverse ----

    /// Creates an object. Its cells are empty.
    pub fn create(
        &mut self,
        class: &'static Class,
        parent: Option<ObjectId>,
        name: &str,
    ) -> Result<ObjectId, NameTaken> {
        if let Some(taken) = self.child_of_kind(parent, name, class) {
            return Err(NameTaken(taken));
        }
        let id = ObjectId(self.objects.len() as u32);
        self.objects.push(None);
        let object = Object { class, name: name.to_string(), parent, children: Vec::new(), cells: Cells::default() };
        let position = self.siblings(parent).len();
        self.attach(id, Box::new(object), position);
        self.record(Change::Created { id });
        Ok(id)
    }

    /// Deletes an object and everything below it.
    pub fn remove(&mut self, id: ObjectId) {
        for child in self.subtree(id).into_iter().rev() {
            let cells = self.object(child).class.cell_count();
            for cell in 0..cells {
                self.set_reads(CellKey::new(child, cell), Vec::new());
            }
            let (object, position) = self.detach(child);
            self.record(Change::Removed { id: child, object, position });
        }
    }

    /// Renames an object, possibly under another parent.
    pub fn rename(&mut self, id: ObjectId, parent: Option<ObjectId>, name: &str) -> Result<(), NameTaken> {
        if let Some(taken) = self.child_of_kind(parent, name, self.object(id).class).filter(|t| *t != id) {
            return Err(NameTaken(taken));
        }
        let old = self.swap_name(id, name.to_string(), parent, None);
        self.record(Change::Named { id, old: Box::new(old) });
        Ok(())
    }

    /// Sets or clears a cell. What it reads is set apart, by [`Database::set_reads`].
    pub fn set_cell(&mut self, key: CellKey, cell: Option<Cell>) {
        let old = self.swap_cell(key, cell);
        self.record(Change::Cell { key, old: old.map(Box::new) });
    }

    /// Sets a literal value in the units in force; no-op for a field the class does not have.
    pub fn set_value(&mut self, id: ObjectId, name: &str, value: Value) {
        if let Some(index) = self.object(id).class.cell_index(name) {
            let key = CellKey::new(id, index);
            let units = self.settings.units;
            self.set_reads(key, Vec::new());
            self.set_cell(key, Some(Cell { value, units, source: crate::Source::Literal }));
        }
    }

    /// Changes settings through a closure.
    pub fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        let old = self.settings.clone();
        change(&mut self.settings);
        if self.settings == old {
            return;
        }
        self.record(Change::Settings { old: Box::new(old) });
    }

    /// Makes an object the current default of its class, its families and, for models and parts,
    /// what bare names go under.
    pub fn make_current(&mut self, id: ObjectId) {
        let class = self.object(id).class;
        let names = || std::iter::once(class.id).chain(class.families.iter().copied());
        let places: Option<SmallVec<[usize; 8]>> =
            names().map(|name| self.settings.current.get_index_of(name)).collect();
        let Some(places) = places else {
            self.change_settings(|s| s.current.extend(names().map(|name| (name, id))));
            return;
        };
        let new = places.iter().filter(|place| self.settings.current[**place] != id).map(|place| (*place as u16, id));
        let new: SmallVec<_> = new.collect();
        if !new.is_empty() {
            let old = self.swap_current(new);
            self.record(Change::Current { old });
        }
    }

    /// Sets the frame that locations and orientations refer to.
    pub fn set_default_frame(&mut self, frame: Option<ObjectId>) {
        if self.settings.default_frame != frame {
            let old = std::mem::replace(&mut self.settings.default_frame, frame);
            self.record(Change::Frame { old });
        }
    }

    /// Puts units in force. Values keep their physical meaning.
    pub fn set_units(&mut self, units: UnitSystem) {
        let known = self.unit_systems.iter().position(|u| *u == units);
        let index = known.unwrap_or_else(|| {
            self.unit_systems.push(units);
            self.unit_systems.len() - 1
        });
        self.change_settings(|s| s.units = UnitsId(index as u16));
    }

    /// Runs a change that may fail; on failure everything it did is taken back.
    pub fn transaction<T, E>(&mut self, change: impl FnOnce(&mut Self) -> Result<T, E>) -> Result<T, E> {
        let mark: Mark = self.mark();
        let outcome = change(self);
        if outcome.is_err() {
            self.roll_back(mark);
        }
        outcome
    }

    // ---- primitives without record, used by undo ----

    pub(crate) fn swap_cell(&mut self, key: CellKey, cell: Option<Cell>) -> Option<Cell> {
        self.touch(key.object);
        let object = self.objects[key.object.0 as usize].as_mut().expect("handle of a living object");
        object.cells.replace(key.cell as usize, cell)
    }

    /// Exchanges current objects at positions of the settings; the last of equal positions comes back
    /// first.
    pub(crate) fn swap_current(
        &mut self,
        mut objects: SmallVec<[(u16, ObjectId); 2]>,
    ) -> SmallVec<[(u16, ObjectId); 2]> {
        for (place, object) in &mut objects {
            std::mem::swap(&mut self.settings.current[*place as usize], object);
        }
        objects.reverse();
        objects
    }

    pub(crate) fn siblings(&mut self, parent: Option<ObjectId>) -> &mut Vec<ObjectId> {
        match parent {
            Some(p) => &mut self.objects[p.0 as usize].as_mut().expect("handle of a living object").children,
            None => &mut self.roots,
        }
    }

    pub(crate) fn attach(&mut self, id: ObjectId, object: Box<Object>, position: usize) {
        self.touch(id);
        let siblings = self.siblings(object.parent);
        let position = position.min(siblings.len());
        siblings.insert(position, id);
        self.objects[id.0 as usize] = Some(object);
        self.names.insert(&self.objects, id);
    }

    pub(crate) fn detach(&mut self, id: ObjectId) -> (Box<Object>, usize) {
        self.touch(id);
        self.names.remove(&self.objects, id);
        let object = self.objects[id.0 as usize].take().expect("handle of a living object");
        object.parent.into_iter().for_each(|p| self.touch(p));
        let siblings = self.siblings(object.parent);
        let position = siblings.iter().rposition(|c| *c == id).unwrap_or(0);
        siblings.remove(position);
        (object, position)
    }

    pub(crate) fn swap_name(
        &mut self,
        id: ObjectId,
        name: String,
        parent: Option<ObjectId>,
        position: Option<usize>,
    ) -> Place {
        self.touch(id);
        self.names.remove(&self.objects, id);
        let old_parent = self.object(id).parent;
        old_parent.into_iter().for_each(|p| self.touch(p));
        let siblings = self.siblings(old_parent);
        let old_position = siblings.iter().rposition(|c| *c == id).unwrap_or(0);
        if old_parent != parent || position.is_some() {
            siblings.remove(old_position);
            let siblings = self.siblings(parent);
            let position = position.unwrap_or(siblings.len()).min(siblings.len());
            siblings.insert(position, id);
        }
        let object = self.objects[id.0 as usize].as_mut().expect("handle of a living object");
        object.parent = parent;
        let old_name = std::mem::replace(&mut object.name, name);
        self.names.insert(&self.objects, id);
        Place { name: old_name, parent: old_parent, position: old_position }
    }
}
