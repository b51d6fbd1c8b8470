//! The cells of one object: most fields of most objects are never given, so only what is set is kept.

use crate::Cell;

/// Cells for which room is made at once. There are few in an object and many objects: doubling would
/// leave a third of a model's memory empty.
const ROOM: usize = 4;

/// The cells of an object that are set, by the number of their field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// In order of their numbers.
    set: Vec<(u16, Cell)>,
}

impl Cells {
    fn place(&self, index: usize) -> Result<usize, usize> {
        // Commands tend to give fields in the order of their class: the new one often comes last.
        if self.set.last().is_none_or(|(last, _)| usize::from(*last) < index) {
            return Err(self.set.len());
        }
        self.set.binary_search_by_key(&index, |(index, _)| usize::from(*index))
    }

    /// The cell of a field; `None` where nothing was given and there is no default.
    pub fn get(&self, index: usize) -> Option<&Cell> {
        self.place(index).ok().map(|place| &self.set[place].1)
    }

    /// Sets or clears a cell; returns what was there.
    pub fn replace(&mut self, index: usize, cell: Option<Cell>) -> Option<Cell> {
        match (self.place(index), cell) {
            (Ok(place), Some(cell)) => Some(std::mem::replace(&mut self.set[place].1, cell)),
            (Ok(place), None) => Some(self.set.remove(place).1),
            (Err(place), Some(cell)) => {
                if self.set.len() == self.set.capacity() {
                    self.set.reserve_exact(ROOM);
                }
                self.set.insert(place, (index as u16, cell));
                None
            }
            (Err(_), None) => None,
        }
    }

    /// The cells that are set with the numbers of their fields, in order.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &Cell)> {
        self.set.iter().map(|(index, cell)| (usize::from(*index), cell))
    }

    /// The cells that are set, in the order of their fields.
    pub fn values(&self) -> impl Iterator<Item = &Cell> {
        self.set.iter().map(|(_, cell)| cell)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::Cells;
    use crate::{Cell, Source, UnitsId, Value};

    fn cell(value: i64) -> Cell {
        Cell { value: Value::Integer(value), units: UnitsId(0), source: Source::Literal }
    }

    proptest! {
        #[test]
        fn they_hold_what_a_full_table_would(changes in prop::collection::vec((0usize..20, prop::option::of(any::<i64>())), 0..60)) {
            let (mut cells, mut table) = (Cells::default(), vec![None; 20]);
            for (index, value) in changes {
                let old = cells.replace(index, value.map(cell));
                prop_assert_eq!(old, std::mem::replace(&mut table[index], value.map(cell)));
            }
            for (index, expected) in table.iter().enumerate() {
                prop_assert_eq!(cells.get(index), expected.as_ref());
            }
            let expected: Vec<_> = table.iter().enumerate().filter_map(|(i, c)| Some((i, c.as_ref()?))).collect();
            prop_assert_eq!(cells.iter().collect::<Vec<_>>(), expected);
        }
    }
}
