//! Inverse changes: rollback of a failed command, undo and redo of whole steps.

use crate::{Cell, CellKey, Database, Object, ObjectId, Settings};

/// One change, holding what is needed to take it back.
#[derive(Clone, Debug)]
pub(crate) enum Change {
    Created { id: ObjectId },
    Removed { id: ObjectId, object: Box<Object>, position: usize },
    Cell { key: CellKey, old: Option<Cell> },
    Named { id: ObjectId, old_name: String, old_parent: Option<ObjectId>, old_position: usize },
    Settings { old: Box<Settings> },
    Reads { cell: CellKey, old: Vec<CellKey> },
}

/// A point in the record of changes to which one can roll back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mark(usize);

#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    /// Changes since the last finished step.
    open: Vec<Change>,
    /// Finished steps, oldest first.
    done: Vec<Vec<Change>>,
    /// Steps undone, the next to redo last.
    undone: Vec<Vec<Change>>,
}

impl Database {
    pub(crate) fn record(&mut self, change: Change) {
        self.revision += u64::from(!matches!(change, Change::Settings { .. }));
        self.history.open.push(change);
    }

    /// The present point of the open step.
    pub fn mark(&self) -> Mark {
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
            let step = std::mem::take(&mut self.history.open);
            self.history.done.push(step);
            self.history.undone.clear();
        }
    }

    /// Forgets how to take back what happened since the last step (`undo begin_block suppress=yes`).
    pub fn forget_open_step(&mut self) {
        self.history.open.clear();
    }

    /// Forgets all steps.
    pub fn flush_history(&mut self) {
        self.history = History::default();
    }

    /// Keeps at most `steps` steps.
    pub fn limit_history(&mut self, steps: usize) {
        let excess = self.history.done.len().saturating_sub(steps);
        self.history.done.drain(..excess);
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
    fn replay(&mut self, step: Vec<Change>) -> Vec<Change> {
        let outer = std::mem::take(&mut self.history.open);
        let mut inverse = Vec::with_capacity(step.len());
        for change in step.into_iter().rev() {
            inverse.push(self.invert(change));
        }
        self.history.open = outer;
        inverse
    }

    /// Takes one change back; returns the change that takes that back in turn.
    fn invert(&mut self, change: Change) -> Change {
        self.revision += u64::from(!matches!(change, Change::Settings { .. }));
        match change {
            Change::Created { id } => {
                let (object, position) = self.detach(id);
                Change::Removed { id, object, position }
            }
            Change::Removed { id, object, position } => {
                self.attach(id, object, position);
                Change::Created { id }
            }
            Change::Cell { key, old } => Change::Cell { key, old: self.swap_cell(key, old) },
            Change::Named { id, old_name, old_parent, old_position } => {
                let (name, parent, position) = self.swap_name(id, old_name, old_parent, Some(old_position));
                Change::Named { id, old_name: name, old_parent: parent, old_position: position }
            }
            Change::Settings { old } => Change::Settings { old: Box::new(std::mem::replace(&mut self.settings, *old)) },
            Change::Reads { cell, old } => Change::Reads { cell, old: self.dependencies.replace(cell, old) },
        }
    }
}
