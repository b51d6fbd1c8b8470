//! Values of objects: what is in a cell, in which units, and where it came from.

use schema::{Default, Field, Kind};
use serde::{Deserialize, Serialize};

use crate::{Expression, ObjectId, UnitsId, stored};

/// A numeric array as expressions use it: column-major, `rows` x `columns`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Array {
    pub rows: usize,
    pub columns: usize,
    #[serde(with = "stored::numbers")]
    pub values: Vec<f64>,
}

impl Array {
    /// A column array `{1, 2, 3}`: ROWS 3, COLS 1.
    pub fn column(values: Vec<f64>) -> Array {
        Array { rows: values.len(), columns: 1, values }
    }
}

/// What a cell holds and what an expression yields. Numbers are in the units recorded with the
/// cell; in expressions, in the units in force.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Value {
    /// `(none)`: no object.
    Nothing,
    Number(#[serde(with = "stored::number")] f64),
    Integer(i64),
    Flag(bool),
    Text(String),
    Object(ObjectId),
    Array(Array),
    Texts(Vec<String>),
    Objects(Vec<ObjectId>),
    Function(FunctionText),
}

impl Value {
    /// What a field holds where nothing is given; none if its default is no plain value.
    pub fn of_default(field: &Field) -> Option<Value> {
        Some(match (field.default, field.kind) {
            (Default::Number(x), Kind::Integer) => Value::Integer(x as i64),
            (Default::Number(x), _) if field.count.least > 1 => Value::Array(Array::column(vec![x; field.count.least])),
            (Default::Number(x), _) => Value::Number(x),
            (Default::Word(word), Kind::Boolean(yes, _)) => Value::Flag(word == yes),
            (Default::Word(word), _) => Value::Text(word.to_string()),
            _ => return None,
        })
    }

    pub fn as_number(&self) -> Option<f64> {
        match *self {
            Value::Number(x) => Some(x),
            Value::Integer(i) => Some(i as f64),
            Value::Flag(b) => Some(f64::from(u8::from(b))),
            Value::Array(Array { ref values, .. }) if values.len() == 1 => Some(values[0]),
            _ => None,
        }
    }

    /// The numbers in order; a scalar is one number.
    pub fn as_numbers(&self) -> Option<Vec<f64>> {
        match self {
            Value::Array(array) => Some(array.values.clone()),
            other => other.as_number().map(|x| vec![x]),
        }
    }

    /// The numbers of an array, or the one real number; empty for anything else.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Value::Array(array) => &array.values,
            Value::Number(number) => std::slice::from_ref(number),
            _ => &[],
        }
    }

    pub fn as_text(&self) -> Option<&str> {
        match self {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    pub fn as_object(&self) -> Option<ObjectId> {
        match self {
            Value::Object(id) => Some(*id),
            Value::Objects(ids) if ids.len() == 1 => Some(ids[0]),
            _ => None,
        }
    }

    /// All objects this value refers to.
    pub fn objects(&self) -> Vec<ObjectId> {
        match self {
            Value::Object(id) => vec![*id],
            Value::Objects(ids) => ids.clone(),
            Value::Function(function) => function.objects(),
            _ => Vec::new(),
        }
    }
}

/// A part of a run-time function text: plain text or the name of an object, held by reference so
/// that it follows a renaming.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Piece {
    Text(String),
    Object(ObjectId),
}

/// A run-time function: text that is not converted when units change, with its object names bound.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct FunctionText {
    pub pieces: Vec<Piece>,
}

impl FunctionText {
    pub fn plain(text: impl Into<String>) -> FunctionText {
        FunctionText { pieces: vec![Piece::Text(text.into())] }
    }

    pub fn objects(&self) -> Vec<ObjectId> {
        self.pieces
            .iter()
            .filter_map(|p| match p {
                Piece::Object(id) => Some(*id),
                Piece::Text(_) => None,
            })
            .collect()
    }

    /// The text with names written by `name`.
    pub fn write(&self, mut name: impl FnMut(ObjectId) -> String) -> String {
        self.pieces
            .iter()
            .map(|p| match p {
                Piece::Text(text) => text.clone(),
                Piece::Object(id) => name(*id),
            })
            .collect()
    }

    pub fn is_empty(&self) -> bool {
        self.pieces.iter().all(|p| matches!(p, Piece::Text(t) if t.trim().is_empty()))
    }
}

/// Where the value of a cell came from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Source {
    /// Typed as a plain value, or computed once by EVAL.
    Literal,
    /// One expression that yields the whole value, kept and re-evaluated.
    Expression(Box<Expression>),
    /// A list in which some elements are expressions. In one word, as nearly every cell is a literal.
    #[allow(clippy::box_collection)]
    Elements(Box<Vec<Option<Expression>>>),
}

/// One value of an object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Evaluated value, numbers in `units`.
    pub value: Value,
    /// Units in force when the value was entered or last computed.
    pub units: UnitsId,
    pub source: Source,
}

impl Cell {
    pub fn is_expression(&self) -> bool {
        !matches!(self.source, Source::Literal)
    }

    /// Every expression of this cell.
    pub fn expressions(&self) -> Vec<&Expression> {
        match &self.source {
            Source::Literal => Vec::new(),
            Source::Expression(e) => vec![e],
            Source::Elements(elements) => elements.iter().flatten().collect(),
        }
    }
}
