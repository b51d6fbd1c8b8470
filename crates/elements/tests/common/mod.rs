//! Builds small models in a database, as commands would.
#![allow(dead_code)]

pub mod sheet;

use flexure_elements::registry;
use model::{Array, Database, FunctionText, ObjectId, Value};
use schema::UnitSystem;

pub struct Build {
    pub database: Database,
    pub model: ObjectId,
    pub ground: ObjectId,
}

impl Build {
    pub fn new(units: UnitSystem) -> Build {
        let mut database = Database::default();
        database.set_units(units);
        let class = |id| registry().class(id).unwrap();
        let model = database.create(class("model"), None, "m").unwrap();
        let ground = database.create(class("ground"), Some(model), "ground").unwrap();
        Build { database, model, ground }
    }

    pub fn add(&mut self, class: &str, parent: ObjectId, name: &str) -> ObjectId {
        let class = registry().class(class).unwrap_or_else(|| panic!("class {class}"));
        self.database.create(class, Some(parent), name).unwrap()
    }

    pub fn set(&mut self, id: ObjectId, cell: &str, value: f64) {
        self.known(id, cell);
        self.database.set_value(id, cell, Value::Number(value));
    }

    pub fn word(&mut self, id: ObjectId, cell: &str, word: &str) {
        self.known(id, cell);
        self.database.set_value(id, cell, Value::Text(word.into()));
    }

    pub fn refer(&mut self, id: ObjectId, cell: &str, to: ObjectId) {
        self.known(id, cell);
        self.database.set_value(id, cell, Value::Object(to));
    }

    pub fn numbers(&mut self, id: ObjectId, cell: &str, values: &[f64]) {
        self.known(id, cell);
        self.database.set_value(id, cell, Value::Array(Array::column(values.to_vec())));
    }

    pub fn function(&mut self, id: ObjectId, cell: &str, text: &str) {
        self.known(id, cell);
        self.database.set_value(id, cell, Value::Function(FunctionText::plain(text)));
    }

    fn known(&self, id: ObjectId, cell: &str) {
        let class = self.database.object(id).class;
        assert!(class.cell_index(cell).is_some(), "{} has no cell {cell}", class.id);
    }

    pub fn marker(&mut self, part: ObjectId, name: &str, location: [f64; 3]) -> ObjectId {
        let marker = self.add("marker", part, name);
        self.numbers(marker, "location", &location);
        marker
    }

    /// A part with mass, centre at its origin and equal inertias.
    pub fn part(&mut self, name: &str, location: [f64; 3], mass: f64, inertia: f64) -> ObjectId {
        let part = self.add("part", self.model, name);
        self.numbers(part, "location", &location);
        let cm = self.marker(part, "cm", [0.0; 3]);
        self.set(part, "mass", mass);
        self.refer(part, "center_of_mass_marker", cm);
        for cell in ["ixx", "iyy", "izz"] {
            self.set(part, cell, inertia);
        }
        part
    }

    /// A beam of given length with the section of a steel bar, in any units.
    pub fn beam(&mut self, name: &str, i: ObjectId, j: ObjectId, length: f64) -> ObjectId {
        let beam = self.add("beam", self.model, name);
        self.refer(beam, "i_marker_name", i);
        self.refer(beam, "j_marker_name", j);
        for (cell, value) in [
            ("length", length),
            ("area_of_cross_section", 78.5),
            ("ixx", 981.0),
            ("iyy", 491.0),
            ("izz", 491.0),
            ("youngs_modulus", 2.07e5),
            ("shear_modulus", 8.0e4),
            ("y_shear_area_ratio", 0.0),
            ("z_shear_area_ratio", 0.0),
            ("damping_ratio", 1e-3),
        ] {
            self.set(beam, cell, value);
        }
        beam
    }

    pub fn joint(&mut self, class: &str, name: &str, i: ObjectId, j: ObjectId) -> ObjectId {
        let joint = self.add(class, self.model, name);
        self.refer(joint, "i_marker_name", i);
        self.refer(joint, "j_marker_name", j);
        joint
    }

    pub fn gravity(&mut self, g: [f64; 3]) {
        let gravity = self.add("gravity", self.model, "gravity");
        for (cell, value) in ["x_component_gravity", "y_component_gravity", "z_component_gravity"].into_iter().zip(g) {
            self.set(gravity, cell, value);
        }
    }
}

pub fn codes(diagnostics: &[text::Diagnostic]) -> Vec<&'static str> {
    diagnostics.iter().map(|d| d.code).collect()
}
