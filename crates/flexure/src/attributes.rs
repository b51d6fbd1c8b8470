//! Objects and their attributes by name: what Python's `beam.youngs_modulus` stands on. Everything
//! comes from the class tables.

use model::{Cell, Database, ObjectId, Value, split_name};

/// A value as doors hand it on.
#[derive(Clone, Debug, PartialEq)]
pub enum AttributeValue {
    None,
    Number(f64),
    Integer(i64),
    Flag(bool),
    /// Text, a word, the full name of an object, or a run-time function.
    Text(String),
    Numbers(Vec<f64>),
    Texts(Vec<String>),
}

/// An attribute in model units.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    pub value: AttributeValue,
    /// Unit label, `newton/mm**2`; empty for a plain number.
    pub unit: String,
    /// Text of the expression that computes it.
    pub expression: Option<String>,
}

/// Finds an object by full name, by a path below the model, or by a short name that is unique
/// below the model.
pub(crate) fn resolve(database: &Database, model: Option<ObjectId>, name: &str, wanted: &str) -> Option<ObjectId> {
    if name.starts_with('.') {
        return database.find(name, wanted);
    }
    let model = model?;
    if let Some(found) = database.descend(Some(model), &split_name(name), wanted) {
        return Some(found);
    }
    let mut named = database.below(model, wanted).into_iter().filter(|id| {
        let object = database.object(*id);
        object.name.eq_ignore_ascii_case(name)
    });
    let first = named.next()?;
    named.next().is_none().then_some(first)
}

pub(crate) fn names(database: &Database, object: &str) -> Vec<String> {
    let Some(id) = database.find(object, "any") else { return Vec::new() };
    let mut names: Vec<String> = Vec::new();
    for field in database.object(id).class.fields() {
        if !names.iter().any(|n| n == field.name) {
            names.push(field.name.to_string());
        }
    }
    names
}

pub(crate) fn read(database: &Database, object: &str, name: &str) -> Option<Attribute> {
    let id = database.find(object, "any")?;
    let field = database.field(id, database.object(id).class.cell_index(name)?);
    let Some(cell) = database.cell(id, name) else {
        return Some(Attribute { value: AttributeValue::None, unit: String::new(), expression: None });
    };
    Some(Attribute {
        value: value(database, id, name, cell),
        unit: database.units().label(field.dimension),
        expression: expression(database, cell),
    })
}

fn value(database: &Database, id: ObjectId, name: &str, cell: &Cell) -> AttributeValue {
    let full = |o: &ObjectId| if database.get(*o).is_some() { database.full_name(*o) } else { String::new() };
    match &cell.value {
        Value::Nothing => AttributeValue::None,
        Value::Number(_) => database.number(id, name).map_or(AttributeValue::None, AttributeValue::Number),
        Value::Integer(i) => AttributeValue::Integer(*i),
        Value::Flag(flag) => AttributeValue::Flag(*flag),
        Value::Text(text) => AttributeValue::Text(text.clone()),
        Value::Object(o) => AttributeValue::Text(full(o)),
        Value::Array(_) => database.numbers(id, name).map_or(AttributeValue::None, AttributeValue::Numbers),
        Value::Texts(texts) => AttributeValue::Texts(texts.clone()),
        Value::Objects(objects) => AttributeValue::Texts(objects.iter().map(full).collect()),
        Value::Function(function) => AttributeValue::Text(function.write(|o| full(&o))),
    }
}

fn expression(database: &Database, cell: &Cell) -> Option<String> {
    let texts: Vec<String> = cell.expressions().into_iter().map(|e| expressions::print(e, database)).collect();
    (!texts.is_empty()).then(|| texts.join(", "))
}
