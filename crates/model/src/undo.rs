//! Inverse changes: rollback of a failed command, undo and redo of whole steps.

use std::collections::BTreeSet;

use smallvec::SmallVec;

use crate::{Cell, CellKey, Database, Object, ObjectId, Settings};

/// One change, holding what is needed to take it back. There is one for nearly every value that is
/// ever set: what is large and rare is boxed.
#[derive(Clone, Debug)]
pub(crate) enum Change {
    Created {
        id: ObjectId,
    },
    Removed {
        id: ObjectId,
        object: Box<Object>,
        position: usize,
    },
    Cell {
        key: CellKey,
        old: Option<Box<Cell>>,
    },
    Named {
        id: ObjectId,
        old: Box<Place>,
    },
    Settings {
        old: Box<Settings>,
    },
    /// Current objects, by position in the settings: the most frequent change of settings.
    Current {
        old: SmallVec<[(u16, ObjectId); 2]>,
    },
    Frame {
        old: Option<ObjectId>,
    },
    Reads {
        cell: CellKey,
        old: Vec<CellKey>,
    },
}

/// Where an object stands in the tree.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub name: String,
    pub parent: Option<ObjectId>,
    pub position: usize,
}

/// A point in the record of changes to which one can roll back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mark(usize);

/// What a step of undo or redo does to objects, each named once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Effect {
    /// Objects that will be gone.
    pub goes: Vec<ObjectId>,
    /// Objects that will be there.
    pub comes: Vec<ObjectId>,
    /// Objects that stay and change.
    pub changes: Vec<ObjectId>,
}

impl Effect {
    /// The effect of taking changes back.
    fn of(step: &[Change]) -> Effect {
        let (mut goes, mut comes, mut changes) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for change in step {
            match change {
                Change::Created { id } => goes.insert(*id),
                Change::Removed { id, .. } => comes.insert(*id),
                Change::Cell { key, .. } => changes.insert(key.object),
                Change::Named { id, .. } => changes.insert(*id),
                _ => false,
            };
        }
        changes.retain(|id| !goes.contains(id) && !comes.contains(id));
        let list = |ids: BTreeSet<ObjectId>| ids.into_iter().collect();
        Effect { goes: list(goes), comes: list(comes), changes: list(changes) }
    }
}

impl Change {
    /// The object that is changed itself.
    fn object(&self) -> Option<ObjectId> {
        match self {
            Change::Created { id } | Change::Removed { id, .. } | Change::Named { id, .. } => Some(*id),
            Change::Cell { key, .. } => Some(key.object),
            Change::Reads { cell, .. } => Some(cell.object),
            _ => None,
        }
    }

    fn concerns_settings(&self) -> bool {
        matches!(self, Change::Settings { .. } | Change::Current { .. } | Change::Frame { .. })
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    /// Changes since the last finished step.
    open: Vec<Change>,
    /// Objects from this handle on were made since the last mark and in the open step: they go with
    /// all their cells when that is taken back, so that their cells need no record.
    fresh_from: u32,
    /// Finished steps, oldest first.
    done: Vec<Box<[Change]>>,
    /// Steps undone, the next to redo last.
    undone: Vec<Box<[Change]>>,
    /// Objects whose changes are not recorded.
    left_out: SmallVec<[ObjectId; 2]>,
}

impl Database {
    pub(crate) fn record(&mut self, change: Change) {
        self.revision += u64::from(!change.concerns_settings());
        let fresh = matches!(&change, Change::Cell { key, .. } if key.object.0 >= self.history.fresh_from);
        let left_out = || change.object().is_some_and(|id| self.history.left_out.contains(&id));
        if !fresh && (self.history.left_out.is_empty() || !left_out()) {
            self.history.open.push(change);
        }
    }

    /// From now on nothing that happens to an object is recorded, nor that it was just made: undo
    /// neither takes it away nor brings it back (the variable of a loop, while the loop runs).
    pub fn leave_out_of_history(&mut self, id: ObjectId) {
        if matches!(self.history.open.last(), Some(Change::Created { id: made }) if *made == id) {
            self.history.open.pop();
        }
        self.history.left_out.push(id);
    }

    /// Ends [`Database::leave_out_of_history`]. An object that is still there counts as made now.
    pub fn take_into_history(&mut self, id: ObjectId) {
        self.history.left_out.retain(|other| *other != id);
        if self.get(id).is_some() {
            self.record(Change::Created { id });
        }
    }

    /// Makes one step of all finished steps behind the first `from`.
    pub fn join_steps(&mut self, from: usize) {
        if self.history.done.len() > from + 1 {
            let joined: Vec<Change> = self.history.done.drain(from..).flat_map(<[Change]>::into_vec).collect();
            self.history.done.push(joined.into());
        }
    }

    /// The present point of the open step.
    pub fn mark(&mut self) -> Mark {
        self.history.fresh_from = self.objects.len() as u32;
        Mark(self.history.open.len())
    }

    /// Whether anything changed since a mark.
    pub fn changed_since(&self, mark: Mark) -> bool {
        self.history.open.len() > mark.0
    }

    /// Takes back everything since `mark`.
    pub fn roll_back(&mut self, mark: Mark) {
        while self.history.open.len() > mark.0 {
            if let Some(change) = self.history.open.pop() {
                self.invert(change);
            }
        }
    }

    /// Closes the open step: what happened since the last call is one step of undo. A step without
    /// changes is none. Redo is lost when something changed.
    pub fn finish_step(&mut self) {
        if !self.history.open.is_empty() {
            let step = self.history.open.drain(..).collect();
            self.history.done.push(step);
            self.history.undone.clear();
        }
        self.history.fresh_from = self.objects.len() as u32;
    }

    /// Forgets how to take back what happened since the last step (`undo begin_block suppress=yes`).
    pub fn forget_open_step(&mut self) {
        self.history.open.clear();
        self.history.fresh_from = self.objects.len() as u32;
    }

    /// Forgets all steps.
    pub fn flush_history(&mut self) {
        let left_out = std::mem::take(&mut self.history.left_out);
        self.history = History { fresh_from: self.objects.len() as u32, left_out, ..History::default() };
    }

    /// Keeps at most `steps` steps.
    pub fn limit_history(&mut self, steps: usize) {
        let excess = self.history.done.len().saturating_sub(steps);
        self.history.done.drain(..excess);
    }

    /// How many steps can be undone and redone.
    pub fn history_depth(&self) -> (usize, usize) {
        (self.history.done.len(), self.history.undone.len())
    }

    /// What undoing the last finished step will do.
    pub fn next_undo(&self) -> Effect {
        self.history.done.last().map_or_else(Effect::default, |step| Effect::of(step))
    }

    /// What redoing the step undone last will do.
    pub fn next_redo(&self) -> Effect {
        self.history.undone.last().map_or_else(Effect::default, |step| Effect::of(step))
    }

    /// Undoes the last step; false if there is none.
    pub fn undo(&mut self) -> bool {
        self.finish_step();
        let Some(step) = self.history.done.pop() else { return false };
        let inverse = self.replay(step);
        self.history.undone.push(inverse);
        true
    }

    /// Redoes the step undone last; false if there is none.
    pub fn redo(&mut self) -> bool {
        if !self.history.open.is_empty() {
            return false;
        }
        let Some(step) = self.history.undone.pop() else { return false };
        let inverse = self.replay(step);
        self.history.done.push(inverse);
        true
    }

    /// Applies the inverses of a step in reverse order and returns the step that takes that back.
    fn replay(&mut self, step: Box<[Change]>) -> Box<[Change]> {
        step.into_iter().rev().map(|change| self.invert(change)).collect()
    }

    /// Takes one change back; returns the change that takes that back in turn.
    fn invert(&mut self, change: Change) -> Change {
        self.revision += u64::from(!change.concerns_settings());
        match change {
            Change::Created { id } => {
                let (object, position) = self.detach(id);
                Change::Removed { id, object, position }
            }
            Change::Removed { id, object, position } => {
                self.attach(id, object, position);
                Change::Created { id }
            }
            Change::Cell { key, old } => {
                let old = self.swap_cell(key, old.map(|cell| *cell));
                Change::Cell { key, old: old.map(Box::new) }
            }
            Change::Named { id, old } => {
                let Place { name, parent, position } = *old;
                Change::Named { id, old: Box::new(self.swap_name(id, name, parent, Some(position))) }
            }
            Change::Settings { old } => Change::Settings { old: Box::new(std::mem::replace(&mut self.settings, *old)) },
            Change::Current { old } => Change::Current { old: self.swap_current(old) },
            Change::Frame { old } => Change::Frame { old: std::mem::replace(&mut self.settings.default_frame, old) },
            Change::Reads { cell, old } => {
                self.touch(cell.object);
                Change::Reads { cell, old: self.dependencies.replace(cell, old) }
            }
        }
    }
}
