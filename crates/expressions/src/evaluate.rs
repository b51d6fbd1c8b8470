//! The value of a bound expression in the units in force, and every cell it read.

use std::collections::HashSet;

use glam::{DMat3, DVec3};
use model::{Array, CellKey, Expression, Node, ObjectId, Pose, Value};
use schema::{Dimension, parse_unit_expression};
use text::Diagnostic;

use crate::{
    Scope, arithmetic, attributes,
    dimension::certain_dimension,
    functions::{self, Arguments},
    scope::{Outcome, problem},
};

/// What an expression comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluated {
    /// Numbers in the units in force; angles in the current angle unit.
    pub value: Value,
    /// Set only when the value is certain to have this dimension.
    pub dimension: Option<Dimension>,
    /// Every cell read, those of poses included, in order of first reading.
    pub reads: Vec<CellKey>,
}

/// Evaluates a bound expression.
#[allow(clippy::result_large_err)] // the interface speaks of diagnostics; errors are rare
pub fn evaluate(expression: &Expression, scope: &Scope) -> Result<Evaluated, Diagnostic> {
    let mut evaluator = Evaluator::new(*scope);
    let value = evaluator.node(&expression.root).map_err(|e| *e)?;
    Ok(Evaluated { value, dimension: certain_dimension(&expression.root), reads: evaluator.reads })
}

/// Walks one expression.
pub(crate) struct Evaluator<'a> {
    pub scope: Scope<'a>,
    pub reads: Vec<CellKey>,
    seen: HashSet<CellKey>,
}

impl<'a> Evaluator<'a> {
    pub fn new(scope: Scope<'a>) -> Evaluator<'a> {
        Evaluator { scope, reads: Vec::new(), seen: HashSet::new() }
    }

    pub fn read(&mut self, cell: CellKey) {
        if self.seen.insert(cell) {
            self.reads.push(cell);
        }
    }

    pub fn node(&mut self, node: &Node) -> Outcome<Value> {
        match node {
            Node::Number { value, text, unit } => self.number(*value, text, unit.as_deref()),
            Node::Text(text) => Ok(Value::Text(text.clone())),
            Node::Nothing => Ok(Value::Nothing),
            Node::Constant(name) => Ok(Value::Number(constant(name))),
            Node::Object(id) => self.object(*id),
            Node::Attribute(inner, name) => {
                let object = self.subject(inner, name)?;
                self.attribute(object, name)
            }
            Node::Index(inner, indices) => {
                let value = self.node(inner)?;
                let indices = indices.iter().map(|i| self.index(i)).collect::<Outcome<Vec<_>>>()?;
                element(&value, &indices)
            }
            Node::Call { function, arguments } => {
                let function = functions::find(function).ok_or_else(|| functions::not_a_function(function))?;
                if !(function.least..=function.most).contains(&arguments.len()) {
                    return Err(functions::wrong_count(function, arguments.len()));
                }
                let values = arguments.iter().map(|a| self.node(a)).collect::<Outcome<Vec<_>>>()?;
                if function.searches {
                    self.read(crate::STRUCTURE);
                }
                let value = (function.run)(&mut Arguments { name: function.name, values: &values, evaluator: self })?;
                check_finite(function.name, value)
            }
            Node::Unary(operator, inner) => arithmetic::unary(*operator, &self.node(inner)?),
            Node::Binary(operator, a, b) => {
                let a = self.node(a)?;
                match operator {
                    // The right side of && and || may be wrong when the left one decides.
                    model::BinaryOperator::And if !arithmetic::truth(&a)? => Ok(arithmetic::flag(false)),
                    model::BinaryOperator::Or if arithmetic::truth(&a)? => Ok(arithmetic::flag(true)),
                    _ => {
                        let b = self.node(b)?;
                        arithmetic::binary(*operator, &a, &b, &self.scope)
                    }
                }
            }
            Node::Conditional(condition, yes, no) => {
                let chosen = if arithmetic::truth(&self.node(condition)?)? { yes } else { no };
                self.node(chosen)
            }
            Node::Array(items) => self.array(items),
            Node::Row(items) => Ok(match self.array(items)? {
                Value::Array(a) if a.columns <= 1 => {
                    Value::Array(Array { rows: 1, columns: a.values.len(), values: a.values })
                }
                other => other,
            }),
            // DB_DEFAULT's first argument names a place that is no object here.
            Node::Unbound(name) if functions::is_defaults(name) => Ok(Value::Nothing),
            Node::Unbound(name) => Err(problem(
                "expression/unknown-name",
                format!("`{name}` is not a known constant, function or variable"),
            )),
        }
    }

    fn number(&self, value: f64, text: &str, unit: Option<&str>) -> Outcome<Value> {
        match unit {
            None if is_integer_text(text) && value.abs() < 9.0e15 => Ok(Value::Integer(value as i64)),
            None => Ok(Value::Number(value)),
            Some(unit) => {
                let (dimension, si) = parse_unit_expression(bare_unit(unit)).ok_or_else(|| unknown_unit(unit))?;
                let in_force = self.scope.database.units().factor(dimension);
                // A value already in the units in force keeps its digits.
                Ok(Value::Number(if si == in_force { value } else { value * (si / in_force) }))
            }
        }
    }

    /// A variable stands for its value, any other object for itself.
    fn object(&mut self, id: ObjectId) -> Outcome<Value> {
        match self.scope.database.get(id) {
            None => Err(attributes::deleted()),
            Some(object) if object.class.id == "variable" => self.variable(id),
            Some(_) => Ok(Value::Object(id)),
        }
    }

    /// The object whose attribute is asked for. A variable is meant itself where it has the
    /// attribute, else the object it holds.
    fn subject(&mut self, inner: &Node, name: &str) -> Outcome<ObjectId> {
        if let Node::Object(id) = inner {
            if self.scope.database.get(*id).is_none() {
                return Err(attributes::deleted());
            }
            if attributes::is_attribute(self.scope.database, *id, name) {
                return Ok(*id);
            }
        }
        let value = self.node(inner)?;
        crate::names::object_or_problem(&value, &self.scope)
    }

    /// One index, or the first and the last of a stretch.
    fn index(&mut self, node: &Node) -> Outcome<(usize, usize, bool)> {
        if let Node::Call { function, arguments } = node
            && &**function == syntax::command::RANGE
            && let [first, last] = arguments.as_slice()
        {
            let (first, last) = (self.position(first)?, self.position(last)?);
            if first > last {
                return Err(problem(
                    "expression/index-out-of-range",
                    format!("elements are counted upwards; {first}:{last} has none"),
                ));
            }
            return Ok((first, last, false));
        }
        self.position(node).map(|i| (i, i, true))
    }

    fn position(&mut self, node: &Node) -> Outcome<usize> {
        let value = self.node(node)?;
        let x = value.as_number().ok_or_else(|| arithmetic::not_a_number(&value))?;
        if x.fract() == 0.0 && (1.0..1e15).contains(&x) {
            Ok(x as usize)
        } else {
            Err(problem(
                "expression/index-out-of-range",
                format!("{} is not an index; elements are counted from 1", crate::print::number_text(x)),
            ))
        }
    }

    fn array(&mut self, items: &[Node]) -> Outcome<Value> {
        let rows = !items.is_empty() && items.iter().all(|n| matches!(n, Node::Row(_)));
        let values = items.iter().map(|n| self.node(n)).collect::<Outcome<Vec<_>>>()?;
        join(values, rows, &self.scope)
    }

    /// The global pose of a frame; all cells it depends on are noted as read.
    pub fn pose(&mut self, frame: Option<ObjectId>) -> Pose {
        let Some(frame) = frame else { return Pose::GLOBAL };
        for cell in self.scope.database.pose_reads(frame) {
            self.read(cell);
        }
        self.scope.database.global_pose(frame)
    }

    /// The global origin of a frame. How the frame itself is turned does not move it and is not
    /// noted as read, so that an orientation may aim at the origin of its own marker.
    pub fn origin(&mut self, frame: Option<ObjectId>) -> DVec3 {
        let Some(frame) = frame else { return DVec3::ZERO };
        let database = self.scope.database;
        let own_turn = database.object(frame).class.cell_index("orientation").map(|c| CellKey::new(frame, c));
        for cell in database.pose_reads(frame) {
            if Some(cell) != own_turn {
                self.read(cell);
            }
        }
        database.global_pose(frame).origin
    }

    /// How a frame is turned in global axes; where it is does not matter and is not noted as read.
    pub fn turn(&mut self, frame: Option<ObjectId>) -> DMat3 {
        let Some(frame) = frame else { return DMat3::IDENTITY };
        let database = self.scope.database;
        for cell in database.pose_reads(frame) {
            if database.object(cell.object).class.field(cell.cell as usize).name == "orientation" {
                self.read(cell);
            }
        }
        database.global_pose(frame).rotation
    }
}

/// Joins elements of `{...}`: numbers to a column, columns side by side, rows one above the other.
fn join(values: Vec<Value>, rows: bool, scope: &Scope) -> Outcome<Value> {
    if values.iter().any(|v| matches!(v, Value::Text(_) | Value::Texts(_))) {
        let mut texts = Vec::new();
        for value in values {
            match value {
                Value::Texts(list) => texts.extend(list),
                other => texts.push(arithmetic::text_of(&other, scope)?),
            }
        }
        return Ok(Value::Texts(texts));
    }
    if values.iter().any(|v| matches!(v, Value::Object(_) | Value::Objects(_))) {
        let mut objects = Vec::new();
        for value in &values {
            match value {
                Value::Object(id) => objects.push(*id),
                Value::Objects(list) => objects.extend(list),
                Value::Nothing => {}
                other => return Err(mixed(other)),
            }
        }
        return Ok(Value::Objects(objects));
    }
    let mut parts = Vec::new();
    for value in values {
        parts.push(match value {
            Value::Array(array) => array,
            other => match other.as_number() {
                Some(x) => Array::column(vec![x]),
                None => return Err(mixed(&other)),
            },
        });
    }
    let Some(first) = parts.first() else { return Ok(Value::Array(Array::column(Vec::new()))) };
    let same = |length: fn(&Array) -> usize| parts.iter().all(|p| length(p) == length(first));
    if rows {
        if !same(|p| p.columns) {
            return Err(problem("expression/shapes-differ", "the rows of a matrix must have the same length"));
        }
        let (count, columns) = (parts.iter().map(|p| p.rows).sum::<usize>(), first.columns);
        let mut stacked = Vec::with_capacity(count * columns);
        for column in 0..columns {
            for part in &parts {
                stacked.extend_from_slice(&part.values[column * part.rows..(column + 1) * part.rows]);
            }
        }
        return Ok(Value::Array(Array { rows: count, columns, values: stacked }));
    }
    if !same(|p| p.rows) {
        return Err(problem("expression/shapes-differ", "the columns of a matrix must have the same length"));
    }
    let (height, width) = (first.rows, parts.iter().map(|p| p.columns).sum::<usize>());
    let values: Vec<f64> = parts.into_iter().flat_map(|p| p.values).collect();
    // Plain numbers make one column; columns stand side by side.
    Ok(Value::Array(if height == 1 { Array::column(values) } else { Array { rows: height, columns: width, values } }))
}

fn mixed(value: &Value) -> Box<Diagnostic> {
    problem("expression/mixed-array", format!("{} cannot be an element of this array", describe(value)))
}

/// Element `[i]` or `[row, column]` of a value, counted from 1, or the elements of a stretch.
fn element(value: &Value, indices: &[(usize, usize, bool)]) -> Outcome<Value> {
    let out = |index: usize, length: usize| {
        problem("expression/index-out-of-range", format!("there is no element {index}; there are {length}"))
    };
    match (value, indices) {
        (Value::Array(a), [rows, columns]) => {
            if rows.1 > a.rows {
                return Err(out(rows.1, a.rows));
            }
            if columns.1 > a.columns {
                return Err(out(columns.1, a.columns));
            }
            let chosen = (columns.0..=columns.1).flat_map(|c| (rows.0..=rows.1).map(move |r| (c - 1) * a.rows + r - 1));
            let values: Vec<f64> = chosen.filter_map(|i| a.values.get(i).copied()).collect();
            Ok(match values.as_slice() {
                [x] if rows.2 && columns.2 => Value::Number(*x),
                _ => Value::Array(Array { rows: rows.1 - rows.0 + 1, columns: columns.1 - columns.0 + 1, values }),
            })
        }
        (value, &[(first, last, single)]) => {
            let length = match value {
                Value::Array(a) => a.values.len(),
                Value::Texts(list) => list.len(),
                Value::Objects(list) => list.len(),
                Value::Number(_) | Value::Integer(_) | Value::Text(_) | Value::Object(_) => 1,
                other => return Err(not_indexable(other)),
            };
            if last > length {
                return Err(out(last, length));
            }
            let chosen = first - 1..last;
            Ok(match value {
                Value::Array(a) if single => Value::Number(a.values[first - 1]),
                Value::Array(a) => Value::Array(Array::column(a.values[chosen].to_vec())),
                Value::Texts(list) if single => Value::Text(list[first - 1].clone()),
                Value::Texts(list) => Value::Texts(list[chosen].to_vec()),
                Value::Objects(list) if single => Value::Object(list[first - 1]),
                Value::Objects(list) => Value::Objects(list[chosen].to_vec()),
                other => other.clone(),
            })
        }
        (other, _) => Err(not_indexable(other)),
    }
}

fn not_indexable(value: &Value) -> Box<Diagnostic> {
    problem("expression/not-indexable", format!("{} has no such elements", describe(value)))
}

/// A function may overflow where its arguments are finite.
fn check_finite(name: &str, value: Value) -> Outcome<Value> {
    let finite = match &value {
        Value::Number(x) => x.is_finite(),
        Value::Array(a) => a.values.iter().all(|x| x.is_finite()),
        _ => true,
    };
    if finite {
        Ok(value)
    } else {
        Err(problem("expression/not-finite", format!("{name} has no finite value for these arguments")))
    }
}

fn constant(name: &str) -> f64 {
    match name {
        "PI" => std::f64::consts::PI,
        "DTOR" => std::f64::consts::PI / 180.0,
        "RTOD" => 180.0 / std::f64::consts::PI,
        _ => 0.0, // TIME: expressions of the model are evaluated at the start
    }
}

/// Digits only: an integer.
pub(crate) fn is_integer_text(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// A unit without the parentheses of its compound form.
pub(crate) fn bare_unit(unit: &str) -> &str {
    unit.strip_prefix('(').and_then(|u| u.strip_suffix(')')).unwrap_or(unit)
}

pub(crate) fn unknown_unit(unit: &str) -> Box<Diagnostic> {
    let bare = bare_unit(unit);
    let diagnostic = Diagnostic::error("expression/unknown-unit", format!("`{bare}` is not a unit"));
    Box::new(crate::unit_help::with_units(diagnostic, bare, None))
}

/// What a value is, for messages.
pub(crate) fn describe(value: &Value) -> String {
    match value {
        Value::Nothing => "(none)".into(),
        Value::Number(_) | Value::Integer(_) | Value::Flag(_) => "a number".into(),
        Value::Text(text) => format!("the text \"{text}\""),
        Value::Object(_) => "an object".into(),
        Value::Array(a) => format!("an array of {} numbers", a.values.len()),
        Value::Texts(list) => format!("{} texts", list.len()),
        Value::Objects(list) => format!("{} objects", list.len()),
        Value::Function(_) => "a run-time function".into(),
    }
}
