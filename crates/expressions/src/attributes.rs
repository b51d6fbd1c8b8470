//! `object.attribute`: fields of an object by full or abbreviated name, and the attributes every
//! object has.

use model::{Array, CellKey, Database, ObjectId, Value};
use schema::Kind;

use crate::{
    evaluate::Evaluator,
    names::{Steps, nearest, reach},
    scope::{Outcome, problem},
};

/// Attributes of every object.
const STANDARD: &[&str] = &["name", "full_name", "short_name", "parent", "self", "children", "type"];

/// Short names of database fields and the command parameters they mean.
pub(crate) const ALIASES: &[(&str, &str)] =
    &[("i", "i_marker_name"), ("j", "j_marker_name"), ("ref_marker", "ref_marker_name"), ("ID", "adams_id")];

/// What an attribute name means on an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Attribute {
    Standard(&'static str),
    Field(usize),
}

/// Fewer letters are a misspelled child rather than the beginning of a field name.
const SHORTEST_BEGINNING: usize = 3;

/// The attribute a name means: exact names first, then unique beginnings of field names.
pub(crate) fn attribute(database: &Database, object: ObjectId, name: &str) -> Option<Attribute> {
    let class = database.get(object)?.class;
    let field = |wanted: &str| class.fields().position(|f| f.name.eq_ignore_ascii_case(wanted));
    if let Some(index) = field(name) {
        return Some(Attribute::Field(index));
    }
    if let Some(word) = STANDARD.iter().find(|s| s.eq_ignore_ascii_case(name)) {
        return Some(Attribute::Standard(word));
    }
    if let Some(index) =
        ALIASES.iter().find(|(short, _)| short.eq_ignore_ascii_case(name)).and_then(|(_, full)| field(full))
    {
        return Some(Attribute::Field(index));
    }
    let lower = name.to_ascii_lowercase();
    let mut matches =
        class.fields().enumerate().filter(|(_, f)| lower.len() >= SHORTEST_BEGINNING && f.name.starts_with(&lower));
    let (first, found) = matches.next()?;
    matches.all(|(_, other)| other.name == found.name).then_some(Attribute::Field(first))
}

pub(crate) fn is_attribute(database: &Database, object: ObjectId, name: &str) -> bool {
    attribute(database, object, name).is_some()
}

/// The full spelling of an attribute.
pub(crate) fn full_name(database: &Database, object: ObjectId, name: &str) -> Option<String> {
    Some(match attribute(database, object, name)? {
        Attribute::Standard(word) => word.to_string(),
        Attribute::Field(index) => {
            let class = database.get(object)?.class;
            // An alias stays what it is: `.i` is what exports write.
            match ALIASES.iter().find(|(short, full)| {
                short.eq_ignore_ascii_case(name) && class.fields().nth(index).is_some_and(|f| f.name == *full)
            }) {
                Some((short, _)) => (*short).to_string(),
                None => class.field(index).name.to_string(),
            }
        }
    })
}

/// Where a dotted name was read as an object and the beginning of an attribute: that object, what
/// was typed, and the attribute.
pub fn read_as_attribute(database: &Database, name: &str) -> Option<(ObjectId, String, String)> {
    let steps = Steps::of(name);
    let reached = reach(database, &steps).ok()?;
    let typed = steps.names.get(reached.steps)?;
    let full = full_name(database, reached.object, typed)?;
    (!full.eq_ignore_ascii_case(typed)).then(|| (reached.object, typed.clone(), full))
}

/// The attribute name nearest to a misspelled one.
pub(crate) fn suggestion(database: &Database, object: ObjectId, name: &str) -> Option<String> {
    let found = database.get(object)?;
    let children = found.children.iter().filter_map(|c| database.get(*c)).map(|c| c.name.as_str());
    nearest(name, found.class.fields().map(|f| f.name).chain(STANDARD.iter().copied()).chain(children))
        .map(str::to_string)
}

/// Adams' word for the type of an object, as DB_TYPE gives it.
pub(crate) fn type_word(database: &Database, object: ObjectId) -> String {
    database.object(object).class.word.to_ascii_lowercase().replace(' ', "_")
}

impl Evaluator<'_> {
    /// The value of an attribute; the cell is noted as read.
    pub fn attribute(&mut self, object: ObjectId, name: &str) -> Outcome<Value> {
        let database = self.scope.database;
        match attribute(database, object, name) {
            Some(Attribute::Standard(word)) => self.standard(object, word),
            Some(Attribute::Field(index)) => self.field(object, index),
            None => Err(unknown_attribute(database, object, name)),
        }
    }

    fn standard(&mut self, id: ObjectId, word: &str) -> Outcome<Value> {
        let database = self.scope.database;
        let Some(object) = database.get(id) else { return Err(deleted()) };
        if !matches!(word, "self" | "type") {
            self.read(crate::STRUCTURE);
        }
        Ok(match word {
            "name" => Value::Text(object.name.clone()),
            "full_name" => Value::Text(database.full_name(id)),
            "short_name" => Value::Text(crate::functions::short_name(database, id)),
            "parent" => object.parent.map_or(Value::Nothing, Value::Object),
            "children" => Value::Objects(object.children.clone()),
            "type" => Value::Text(type_word(database, id)),
            _ => Value::Object(id),
        })
    }

    fn field(&mut self, id: ObjectId, index: usize) -> Outcome<Value> {
        let database = self.scope.database;
        let object = database.object(id);
        let field = database.field(id, index);
        self.read(CellKey::new(id, index));
        let Some(cell) = object.cells.get(index) else {
            return match (field.kind, field.name) {
                (Kind::Location | Kind::Orientation, "location" | "orientation") => {
                    Ok(Value::Array(Array::column(vec![0.0; 3])))
                }
                (Kind::Integer, "adams_id") => Ok(Value::Integer(0)),
                (Kind::Object(..), _) => Ok(Value::Nothing),
                (Kind::Text | Kind::File | Kind::Function, _) => Ok(Value::Text(String::new())),
                _ => Err(problem(
                    "expression/no-value",
                    format!("`{}` of `{}` has no value", field.name, database.full_name(id)),
                )),
            };
        };
        let ratio = database.ratio(cell.units, field.dimension);
        Ok(match &cell.value {
            Value::Number(x) if ratio != 1.0 => Value::Number(x * ratio),
            Value::Integer(i) if ratio != 1.0 => Value::Number(*i as f64 * ratio),
            Value::Array(a) if ratio != 1.0 => {
                Value::Array(Array { values: a.values.iter().map(|x| x * ratio).collect(), ..a.clone() })
            }
            Value::Flag(flag) => crate::arithmetic::flag(*flag),
            Value::Function(function) => Value::Text(function.write(|o| database.full_name(o))),
            Value::Object(o) if database.get(*o).is_none() => return Err(deleted()),
            other => other.clone(),
        })
    }

    /// The value of a design variable: real, integer, text or objects, whichever it has.
    pub fn variable(&mut self, id: ObjectId) -> Outcome<Value> {
        match value_cell(self.scope.database, id) {
            Some(index) => self.field(id, index),
            None => Ok(Value::Object(id)),
        }
    }
}

/// The cell that holds the value of a design variable.
pub(crate) fn value_cell(database: &Database, id: ObjectId) -> Option<usize> {
    let object = database.get(id)?;
    let cells = ["real_value", "integer_value", "string_value", "object_value"];
    let mut cells = cells.into_iter().filter_map(|name| object.class.cell_index(name));
    let set = cells.find(|&c| object.cells.get(c).is_some());
    set.or_else(|| object.class.cell_index("real_value"))
}

pub(crate) fn deleted() -> Box<text::Diagnostic> {
    problem("expression/object-deleted", "an object this expression refers to has been deleted")
}

pub(crate) fn unknown_attribute(database: &Database, object: ObjectId, name: &str) -> Box<text::Diagnostic> {
    let owner = database.full_name(object);
    let mut diagnostic = text::Diagnostic::error(
        "expression/unknown-attribute",
        format!("`{owner}` has neither a child nor an attribute `{name}`"),
    )
    .adams(format!("\"{name}\" is neither a field in nor a child of \"{owner}\""));
    if let Some(near) = suggestion(database, object, name) {
        diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
    }
    Box::new(diagnostic)
}
