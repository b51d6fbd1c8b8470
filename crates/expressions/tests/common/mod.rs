//! A small model and short ways to evaluate text on it.
#![allow(dead_code)] // each test file uses its part

use flexure_expressions as expressions;
use flexure_expressions::{Bound, Evaluated, Scope, bind, compute, evaluate};
use model::{Cell, CellKey, Database, Expression, ObjectId, Source, Value};
use schema::{Class, Count, Dimension, Field, Group};
use text::{Diagnostic, Sources};

const fn class(
    id: &'static str,
    word: &'static str,
    families: &'static [&'static str],
    groups: &'static [Group],
) -> Class {
    Class { id, word, families, parents: &[], prefix: "", statement: None, groups }
}

const fn group(fields: &'static [Field]) -> Group {
    Group { command: "", creates: true, object: "", fields, rules: &[], doc: "test" }
}

const PLACE: &[Field] = &[
    Field::integer("adams_id"),
    Field::location("location"),
    Field::orientation("orientation"),
    Field::object("relative_to", "any"),
];

pub static MODEL: Class = class("model", "Model", &[], &[]);
const MASS: &[Field] = &[
    Field::new("active", schema::Kind::Boolean("on", "off")),
    Field::real("mass", Dimension::MASS),
    Field::object("center_of_mass_marker", "marker"),
    Field::object("inertia_marker", "marker"),
    Field::real("ixx", Dimension::INERTIA),
    Field::real("iyy", Dimension::INERTIA),
    Field::real("izz", Dimension::INERTIA),
    Field::real("ixy", Dimension::INERTIA),
    Field::real("izx", Dimension::INERTIA),
    Field::real("iyz", Dimension::INERTIA),
];

pub static PART: Class = class("part", "Part", &["body"], &[group(PLACE), group(MASS)]);
pub static MARKER: Class = class("marker", "Marker", &["frame"], &[group(PLACE)]);
pub static VARIABLE: Class = class(
    "variable",
    "Variable",
    &[],
    &[group(&[
        Field::real("real_value", Dimension::NONE).many(),
        Field::integer("integer_value").many(),
        Field::texts("string_value"),
        Field::objects("object_value", "any"),
        Field::text("units"),
    ])],
);
pub static BEAM: Class = class(
    "beam",
    "Beam",
    &["force"],
    &[group(&[
        Field::integer("adams_id"),
        Field::object("i_marker_name", "marker"),
        Field::object("j_marker_name", "marker"),
        Field::real("length", Dimension::LENGTH),
        Field::real("youngs_modulus", Dimension::PRESSURE),
        Field::real("values", Dimension::NONE).count(Count::between(1, 9)),
    ])],
);

/// `.m` with `ground`, `p1` (at 100, 0, 0, turned 90 degrees about z) and `p2`, markers and a beam.
pub struct Fixture {
    pub db: Database,
    pub m: ObjectId,
    pub p1: ObjectId,
    pub m1: ObjectId,
    pub beam: ObjectId,
}

pub fn place(db: &mut Database, id: ObjectId, location: [f64; 3], orientation: [f64; 3]) {
    db.set_value(id, "location", Value::Array(model::Array::column(location.to_vec())));
    db.set_value(id, "orientation", Value::Array(model::Array::column(orientation.to_vec())));
}

pub fn fixture() -> Fixture {
    let mut db = Database::default();
    let m = db.create(&MODEL, None, "m").unwrap();
    let ground = db.create(&PART, Some(m), "ground").unwrap();
    let reference = db.create(&MARKER, Some(ground), "ref").unwrap();
    place(&mut db, reference, [150.0, 0.0, 0.0], [0.0; 3]);
    let p1 = db.create(&PART, Some(m), "p1").unwrap();
    place(&mut db, p1, [100.0, 0.0, 0.0], [90.0, 0.0, 0.0]);
    let m1 = db.create(&MARKER, Some(p1), "m1").unwrap();
    place(&mut db, m1, [10.0, 0.0, 0.0], [0.0; 3]);
    let p2 = db.create(&PART, Some(m), "p2").unwrap();
    let cm = db.create(&MARKER, Some(p2), "cm").unwrap();
    place(&mut db, cm, [3.0, 4.0, 0.0], [0.0, 90.0, 0.0]);
    let beam = db.create(&BEAM, Some(m), "b").unwrap();
    db.set_value(beam, "i_marker_name", Value::Object(m1));
    db.set_value(beam, "length", Value::Number(420.0));
    db.make_current(m);
    Fixture { db, m, p1, m1, beam }
}

pub fn variable(db: &mut Database, name: &str, field: &str, value: Value) -> ObjectId {
    let id = db.create(&VARIABLE, db.current("model"), name).unwrap();
    db.set_value(id, field, value);
    id
}

pub fn key(db: &Database, object: ObjectId, field: &str) -> CellKey {
    CellKey::new(object, db.object(object).class.cell_index(field).unwrap())
}

pub fn bound_for(db: &Database, text: &str, owner: Option<ObjectId>) -> Result<Bound, Vec<Diagnostic>> {
    let mut sources = Sources::default();
    let file = sources.add("t.cmd", text);
    let (tree, errors) = syntax::command::parse_expression(file, text, 0);
    assert!(errors.is_empty(), "{text}: {errors:?}");
    let mut scope = Scope::new(db, &sources);
    scope.owner = owner;
    bind(&tree, &scope)
}

pub fn bound(db: &Database, text: &str) -> Expression {
    match bound_for(db, text, None) {
        Ok(Bound::Expression(expression)) => expression,
        other => panic!("{text}: {other:?}"),
    }
}

pub fn evaluated(db: &Database, text: &str) -> Result<Evaluated, Diagnostic> {
    let bound = bound_for(db, text, None).map_err(|e| e.into_iter().next().unwrap())?;
    let sources = Sources::default();
    match bound {
        Bound::Expression(e) => evaluate(&e, &Scope::new(db, &sources)),
        Bound::Value(v) => Ok(v),
    }
}

pub fn value(db: &Database, text: &str) -> Value {
    evaluated(db, text).unwrap_or_else(|e| panic!("{text}: {}", e.message)).value
}

pub fn error(db: &Database, text: &str) -> Diagnostic {
    match evaluated(db, text) {
        Err(error) => error,
        Ok(v) => panic!("{text} gives {v:?}"),
    }
}

pub fn numbers(db: &Database, text: &str) -> Vec<f64> {
    value(db, text).as_numbers().unwrap_or_else(|| panic!("{text} is not numeric"))
}

/// Compares within `tolerance`, absolute.
pub fn near(db: &Database, text: &str, expected: &[f64], tolerance: f64) {
    let found = numbers(db, text);
    assert_eq!(found.len(), expected.len(), "{text} = {found:?}");
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= tolerance, "{text} = {found:?}, not {expected:?}");
    }
}

pub fn text_value(db: &Database, text: &str) -> String {
    match value(db, text) {
        Value::Text(t) => t,
        other => panic!("{text} = {other:?}"),
    }
}

/// Puts an expression into a cell as a command does.
pub fn set(db: &mut Database, object: ObjectId, field: &str, text: &str) -> Result<(), Diagnostic> {
    let Ok(Bound::Expression(e)) = bound_for(db, text, Some(object)) else { panic!("{text}") };
    let key = key(db, object, field);
    let source = Source::Expression(Box::new(e));
    let computed = compute(db, key, &source)?;
    let units = db.settings().units;
    db.set_cell(key, Some(Cell { value: computed.value, units, source }));
    db.set_reads(key, computed.reads);
    expressions::recompute(db, &[key])
}
