//! Values of two objects side by side.

use model::{Cell, Database, Expression, FunctionText, Node, ObjectId, Piece, Source, Value};
use schema::{Dimension, Field, Kind};

use super::pairs::Pairs;
use super::{ValueChange, Why};

/// Conversion of units costs a few units in the last place of the sixteen digits a number has.
const ROUNDING: f64 = 1e-12;
/// Entries of the matrices of two rotations that are the same: angles are written with ten decimals, of
/// which the last may be off by a half; three in sequence add up.
const SAME_AXES: f64 = 1e-9;

/// Two databases, and what counts as equal.
pub(super) struct Comparison<'a> {
    pub a: &'a Database,
    pub b: &'a Database,
    pub tolerance: f64,
}

impl Comparison<'_> {
    /// How many values of two objects are equal, and how many there are to compare. References to
    /// objects without counterpart say nothing yet.
    pub fn likeness(&self, a: ObjectId, b: ObjectId, pairs: &Pairs) -> (f64, f64) {
        let (mut equal, mut all) = (0.0, 0.0);
        for (_, x, y, field) in self.cells(a, b) {
            let unknown = |cell: Option<&Cell>, known: &dyn Fn(ObjectId) -> bool| {
                cell.is_some_and(|c| c.value.objects().into_iter().any(|o| !known(o)))
            };
            if unknown(x, &|o| pairs.forward.contains_key(&o)) && unknown(y, &|o| pairs.backward.contains_key(&o)) {
                continue;
            }
            all += 1.0;
            equal += f64::from(u8::from(self.difference(x, y, &field, pairs).is_none()));
        }
        (equal, all)
    }

    /// The values that differ, in the order of the class.
    pub fn changes(&self, a: ObjectId, b: ObjectId, pairs: &Pairs) -> Vec<ValueChange> {
        let class = self.b.object(b).class.word;
        let mut found = Vec::new();
        for (attribute, x, y, field) in self.cells(a, b) {
            let Some(why) = self.difference(x, y, &field, pairs) else { continue };
            let before = x.map(|c| shown(self.a, c, &field));
            let after = y.map(|c| shown(self.b, c, &field));
            found.push(ValueChange { class, name: String::new(), attribute, before, after, why });
        }
        found
    }

    /// Cells of two objects of one class by name, where either is set.
    fn cells(
        &self,
        a: ObjectId,
        b: ObjectId,
    ) -> impl Iterator<Item = (&'static str, Option<&Cell>, Option<&Cell>, Field)> {
        let class = self.a.object(a).class;
        let placed = class.cell_index("location").is_some();
        class.fields().enumerate().filter_map(move |(i, field)| {
            // Groups of one class share fields of equal name; positions are kept in the parent's
            // frame, and `relative_to` only says how they were typed.
            if class.cell_index(field.name) != Some(i) || placed && field.name == "relative_to" {
                return None;
            }
            let (x, y) = (set(self.a, a, field.name), set(self.b, b, field.name));
            // An object whose kind of quantity changed differs in that already.
            (x.is_some() || y.is_some()).then(|| (field.name, x, y, self.b.field(b, i)))
        })
    }

    /// Why two cells differ; none if they do not.
    fn difference(&self, x: Option<&Cell>, y: Option<&Cell>, field: &Field, pairs: &Pairs) -> Option<Why> {
        let (Some(x), Some(y)) = (x, y) else { return (x.is_some() != y.is_some()).then_some(Why::Given) };
        let value = self.same_value(x, y, field, pairs);
        let computed = same_source(&x.source, &y.source, pairs);
        match (value, computed) {
            (true, true) => None,
            (true, false) => Some(Why::SameValue),
            (false, true) if x.is_expression() => Some(Why::SameExpression),
            (false, _) => Some(Why::Given),
        }
    }

    fn same_value(&self, x: &Cell, y: &Cell, field: &Field, pairs: &Pairs) -> bool {
        let dimension = field.dimension;
        match (&x.value, &y.value) {
            (Value::Text(a), Value::Text(b)) => a == b,
            (Value::Texts(a), Value::Texts(b)) => a == b,
            (Value::Function(a), Value::Function(b)) => same_function(a, b, pairs),
            (Value::Object(_) | Value::Objects(_), _) | (_, Value::Object(_) | Value::Objects(_)) => {
                let (a, b) = (x.value.objects(), y.value.objects());
                a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| self.same_object(*a, *b, pairs))
            }
            _ => {
                let si = |database: &Database, cell: &Cell| -> Option<Vec<f64>> {
                    let factor = database.unit_system(cell.units).factor(dimension);
                    let factor = if dimension == Dimension::NONE { 1.0 } else { factor };
                    Some(cell.value.as_numbers()?.into_iter().map(|n| n * factor).collect())
                };
                match (si(self.a, x), si(self.b, y)) {
                    (Some(a), Some(b)) if field.kind == Kind::Orientation => self.same_axes(&a, &b),
                    (Some(a), Some(b)) => self.same_numbers(&a, &b),
                    _ => x.value == y.value,
                }
            }
        }
    }

    /// Lists are compared by their largest number: a zero that a change of axes left at 1E-17 is one.
    fn same_numbers(&self, a: &[f64], b: &[f64]) -> bool {
        let size = a.iter().chain(b).fold(0.0_f64, |size, n| size.max(n.abs()));
        let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= size * ROUNDING.max(self.tolerance);
        a.len() == b.len() && a.iter().zip(b.iter()).all(close)
    }

    /// Angles are compared by the axes that they turn to: -90 degrees are 270.
    fn same_axes(&self, a: &[f64], b: &[f64]) -> bool {
        let (&[a0, a1, a2], &[b0, b1, b2]) = (a, b) else { return self.same_numbers(a, b) };
        let turned = |angles| model::rotation_of(model::Sequence::BODY_313, angles);
        turned([a0, a1, a2]).abs_diff_eq(turned([b0, b1, b2]), SAME_AXES.max(self.tolerance))
    }

    fn same_object(&self, a: ObjectId, b: ObjectId, pairs: &Pairs) -> bool {
        match (pairs.forward.get(&a), pairs.backward.contains_key(&b)) {
            (Some(other), _) => *other == b,
            (None, true) => false,
            // Outside of the models: libraries and colours.
            (None, false) => {
                let name = |database: &Database, id| database.get(id).map(|_| database.full_name(id));
                name(self.a, a) == name(self.b, b)
            }
        }
    }
}

/// A cell that holds something: no number yet is the same as none.
fn set<'a>(database: &'a Database, id: ObjectId, name: &str) -> Option<&'a Cell> {
    let empty = |value: &Value| match value {
        Value::Nothing => true,
        Value::Integer(0) => name == "adams_id",
        Value::Texts(texts) => texts.is_empty(),
        Value::Objects(objects) => objects.is_empty(),
        Value::Function(function) => function.is_empty(),
        _ => false,
    };
    database.cell(id, name).filter(|cell| !empty(&cell.value))
}

fn same_source(a: &Source, b: &Source, pairs: &Pairs) -> bool {
    let same = |a: &Expression, b: &Expression| {
        // Numbers count by value, objects by what they are in the second model.
        let first = translated(&a.root, &|id| pairs.forward.get(&id).copied().unwrap_or(id));
        first == translated(&b.root, &|id| id)
    };
    match (a, b) {
        (Source::Literal, Source::Literal) => true,
        (Source::Expression(a), Source::Expression(b)) => same(a, b),
        (Source::Elements(a), Source::Elements(b)) => {
            a.len() == b.len()
                && a.iter().zip(b.iter()).all(|pair| match pair {
                    (Some(a), Some(b)) => same(a, b),
                    (a, b) => a.is_none() && b.is_none(),
                })
        }
        _ => false,
    }
}

/// A node with other objects, and without the digits that numbers were typed with.
fn translated(node: &Node, to: &dyn Fn(ObjectId) -> ObjectId) -> Node {
    let one = |node: &Node| Box::new(translated(node, to));
    let all = |nodes: &[Node]| nodes.iter().map(|n| translated(n, to)).collect::<Vec<_>>();
    match node {
        Node::Number { value, unit, .. } => Node::Number { value: *value, text: "".into(), unit: unit.clone() },
        Node::Object(id) => Node::Object(to(*id)),
        Node::Attribute(inner, name) => Node::Attribute(one(inner), name.clone()),
        Node::Index(inner, indices) => Node::Index(one(inner), all(indices)),
        Node::Call { function, arguments } => {
            Node::Call { function: function.to_ascii_lowercase().into(), arguments: all(arguments) }
        }
        Node::Unary(operator, inner) => Node::Unary(*operator, one(inner)),
        Node::Binary(operator, a, b) => Node::Binary(*operator, one(a), one(b)),
        Node::Conditional(a, b, c) => Node::Conditional(one(a), one(b), one(c)),
        Node::Array(nodes) => Node::Array(all(nodes)),
        Node::Row(nodes) => Node::Row(all(nodes)),
        Node::Text(_) | Node::Nothing | Node::Constant(_) | Node::Unbound(_) => node.clone(),
    }
}

/// Functions are text with objects in it; blanks between words do not count.
fn same_function(a: &FunctionText, b: &FunctionText, pairs: &Pairs) -> bool {
    #[derive(PartialEq)]
    enum Part {
        Text(String),
        Object(ObjectId),
    }
    let parts = |function: &FunctionText, to: &dyn Fn(ObjectId) -> ObjectId| {
        let mut parts: Vec<Part> = Vec::new();
        for piece in &function.pieces {
            match piece {
                Piece::Object(id) => parts.push(Part::Object(to(*id))),
                Piece::Text(text) => {
                    let text: String = text.split_whitespace().collect();
                    match parts.last_mut() {
                        Some(Part::Text(before)) => before.push_str(&text),
                        _ if text.is_empty() => {}
                        _ => parts.push(Part::Text(text)),
                    }
                }
            }
        }
        parts
    };
    parts(a, &|id| pairs.forward.get(&id).copied().unwrap_or(id)) == parts(b, &|id| id)
}

/// A value for people, with its unit and the expression that yields it.
fn shown(database: &Database, cell: &Cell, field: &Field) -> String {
    let name = |id: &ObjectId| if database.get(*id).is_some() { database.full_name(*id) } else { "(deleted)".into() };
    let unit = database.unit_system(cell.units).label(field.dimension);
    let value = match &cell.value {
        Value::Nothing => "none".to_owned(),
        Value::Number(x) => format!("{x:?}"),
        Value::Integer(i) => i.to_string(),
        Value::Flag(flag) => match field.kind {
            Kind::Boolean(yes, no) => if *flag { yes } else { no }.to_owned(),
            _ => u8::from(*flag).to_string(),
        },
        Value::Text(text) if matches!(field.kind, Kind::Choice(_)) => text.clone(),
        Value::Text(text) => format!("{text:?}"),
        Value::Texts(texts) => texts.iter().map(|t| format!("{t:?}")).collect::<Vec<_>>().join(", "),
        Value::Object(id) => name(id),
        Value::Objects(ids) => ids.iter().map(name).collect::<Vec<_>>().join(", "),
        Value::Array(array) => array.values.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", "),
        Value::Function(function) => format!("{:?}", function.write(|id| name(&id))),
    };
    let expressions: Vec<String> =
        cell.expressions().into_iter().map(|e| format!("({})", expressions::print(e, database))).collect();
    let unit = if unit.is_empty() { unit } else { format!(" {unit}") };
    let from = if expressions.is_empty() { String::new() } else { format!(" = {}", expressions.join(", ")) };
    format!("{value}{unit}{from}")
}
