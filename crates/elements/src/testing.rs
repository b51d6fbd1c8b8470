//! Small models for the tests of this crate.

use model::{Array, Database, ObjectId, Value};
use schema::{Registry, UnitSystem};

use crate::registry;

/// Builds models the way commands do, in the units of the export the numbers are from.
pub struct Build {
    pub database: Database,
    registry: Registry,
}

impl Build {
    pub fn new() -> Build {
        let mut database = Database::default();
        database.set_units(UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees").unwrap());
        Build { database, registry: registry() }
    }

    pub fn make(&mut self, class: &str, parent: Option<ObjectId>, name: &str, cells: &[(&str, Value)]) -> ObjectId {
        let id = self.database.create(self.registry.class(class).unwrap(), parent, name).unwrap();
        for (cell, value) in cells {
            assert!(self.database.object(id).class.cell_index(cell).is_some(), "{class} has no {cell}");
            self.database.set_value(id, cell, value.clone());
        }
        id
    }

    pub fn marker(&mut self, part: ObjectId, name: &str, at: [f64; 3], turned: [f64; 3]) -> ObjectId {
        let list = |v: [f64; 3]| Value::Array(Array::column(v.to_vec()));
        self.make("marker", Some(part), name, &[("location", list(at)), ("orientation", list(turned))])
    }
}
