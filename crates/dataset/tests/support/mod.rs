//! Builds models by hand, as commands would.
#![allow(dead_code)] // each test file uses its own part

use model::{Array, Database, FunctionText, ObjectId, Piece, Value};
use schema::{Registry, UnitSystem};

pub struct Bench {
    pub database: Database,
    pub registry: Registry,
    pub model: ObjectId,
    pub ground: ObjectId,
}

impl Bench {
    pub fn new(name: &str, units: UnitSystem) -> Bench {
        let registry = elements::registry();
        let mut database = Database::default();
        database.set_units(units);
        let model = database.create(registry.class("model").unwrap(), None, name).unwrap();
        let ground = database.create(registry.class("ground").unwrap(), Some(model), "ground").unwrap();
        Bench { database, registry, model, ground }
    }

    pub fn add(&mut self, class: &str, parent: ObjectId, name: &str, id: i64) -> ObjectId {
        let class = self.registry.class(class).unwrap_or_else(|| panic!("class {class}"));
        let object = self.database.create(class, Some(parent), name).unwrap();
        self.set(object, "adams_id", Value::Integer(id));
        object
    }

    /// An object of the model itself.
    pub fn model_object(&mut self, class: &str, name: &str, id: i64) -> ObjectId {
        self.add(class, self.model, name, id)
    }

    pub fn marker(&mut self, parent: ObjectId, name: &str, id: i64, r: [f64; 3], angles: [f64; 3]) -> ObjectId {
        let marker = self.add("marker", parent, name, id);
        self.numbers(marker, "location", &r);
        self.numbers(marker, "orientation", &angles);
        marker
    }

    pub fn set(&mut self, object: ObjectId, field: &str, value: Value) {
        self.database.set_value(object, field, value);
    }

    pub fn number(&mut self, object: ObjectId, field: &str, x: f64) {
        self.set(object, field, Value::Number(x));
    }

    pub fn numbers(&mut self, object: ObjectId, field: &str, values: &[f64]) {
        self.set(object, field, Value::Array(Array::column(values.to_vec())));
    }

    pub fn word(&mut self, object: ObjectId, field: &str, word: &str) {
        self.set(object, field, Value::Text(word.to_string()));
    }

    pub fn between(&mut self, object: ObjectId, i: ObjectId, j: ObjectId) {
        self.set(object, "i_marker_name", Value::Object(i));
        self.set(object, "j_marker_name", Value::Object(j));
    }

    pub fn function(&mut self, object: ObjectId, field: &str, pieces: Vec<Piece>) {
        self.set(object, field, Value::Function(FunctionText { pieces }));
    }

    pub fn mass(&mut self, part: ObjectId, mass: f64, center: ObjectId, moments: [f64; 3]) {
        self.number(part, "mass", mass);
        self.set(part, "center_of_mass_marker", Value::Object(center));
        for (name, moment) in ["ixx", "iyy", "izz"].iter().zip(moments) {
            self.number(part, name, moment);
        }
    }

    pub fn text(&mut self) -> String {
        self.written().text
    }

    pub fn written(&mut self) -> flexure_dataset::Written {
        flexure_dataset::write(&mut self.database, self.model, flexure_dataset::Options::default())
            .unwrap_or_else(|e| panic!("{e:#?}"))
    }
}

pub fn text(t: &str) -> Piece {
    Piece::Text(t.to_string())
}
