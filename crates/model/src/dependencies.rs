//! Which cell was computed from which: the graph that re-evaluates expressions.

use rustc_hash::{FxHashMap, FxHashSet};

use serde::{Deserialize, Serialize};

use crate::{Database, ObjectId, undo::Change};

/// One cell of one object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct CellKey {
    pub object: ObjectId,
    pub cell: u16,
}

impl CellKey {
    pub fn new(object: ObjectId, cell: usize) -> CellKey {
        CellKey { object, cell: cell as u16 }
    }
}

/// Cells that depend on themselves, in order round the circle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle(pub Vec<CellKey>);

#[derive(Clone, Debug, Default)]
pub(crate) struct Dependencies {
    /// Cells that each computed cell read when it was last evaluated.
    reads: FxHashMap<CellKey, Vec<CellKey>>,
    /// The reverse, in order of registration.
    dependents: FxHashMap<CellKey, Vec<CellKey>>,
}

impl Dependencies {
    /// Replaces what `cell` reads; returns what it read before.
    pub fn replace(&mut self, cell: CellKey, reads: Vec<CellKey>) -> Vec<CellKey> {
        let old = self.reads.remove(&cell).unwrap_or_default();
        for read in &old {
            if let Some(list) = self.dependents.get_mut(read) {
                list.retain(|c| *c != cell);
                if list.is_empty() {
                    self.dependents.remove(read);
                }
            }
        }
        for read in &reads {
            let list = self.dependents.entry(*read).or_default();
            if !list.contains(&cell) {
                list.push(cell);
            }
        }
        if !reads.is_empty() {
            self.reads.insert(cell, reads);
        }
        old
    }
}

impl Database {
    /// Records which cells a computed cell read. Empty for a plain value.
    pub fn set_reads(&mut self, cell: CellKey, reads: Vec<CellKey>) {
        if reads.is_empty() && !self.dependencies.reads.contains_key(&cell) {
            return;
        }
        self.touch(cell.object);
        let old = self.dependencies.replace(cell, reads);
        self.record(Change::Reads { cell, old });
    }

    /// Cells computed directly from a cell.
    pub fn dependents(&self, cell: CellKey) -> &[CellKey] {
        self.dependencies.dependents.get(&cell).map_or(&[], Vec::as_slice)
    }

    /// What a computed cell read.
    pub fn reads(&self, cell: CellKey) -> &[CellKey] {
        self.dependencies.reads.get(&cell).map_or(&[], Vec::as_slice)
    }

    /// Every cell that must be computed again after `changed` cells changed, each after all that it
    /// reads. The changed cells themselves are not in the list unless they are in a circle, which
    /// is an error.
    pub fn affected(&self, changed: &[CellKey]) -> Result<Vec<CellKey>, Cycle> {
        enum Step {
            Enter(CellKey),
            Leave(CellKey),
        }
        let (mut order, mut done, mut open) = (Vec::new(), FxHashSet::default(), Vec::new());
        let mut on_path = FxHashSet::default();
        for &start in changed {
            let mut stack = vec![Step::Enter(start)];
            while let Some(step) = stack.pop() {
                match step {
                    Step::Enter(cell) => {
                        if on_path.contains(&cell) {
                            let from = open.iter().position(|c| *c == cell).unwrap_or(0);
                            return Err(Cycle(open[from..].to_vec()));
                        }
                        if !done.insert(cell) {
                            continue;
                        }
                        on_path.insert(cell);
                        open.push(cell);
                        stack.push(Step::Leave(cell));
                        stack.extend(self.dependents(cell).iter().rev().map(|c| Step::Enter(*c)));
                    }
                    Step::Leave(cell) => {
                        on_path.remove(&cell);
                        open.pop();
                        order.push(cell);
                    }
                }
            }
        }
        order.reverse();
        order.retain(|c| !changed.contains(c));
        Ok(order)
    }
}
