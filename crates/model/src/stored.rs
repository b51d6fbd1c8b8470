//! The database as plain data, for files that keep it: which objects changed since it was last
//! written, and how it is put together again. What the text of a file looks like is not known here.

use std::collections::BTreeSet;

use schema::{Class, UnitSystem};
use serde::{Deserialize, Serialize};

use crate::{BinaryOperator, CellKey, Cells, Database, Expression, Node, Object, ObjectId, Settings, UnaryOperator};

/// An object as it is put back: with what its cells were computed from.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredObject {
    pub id: ObjectId,
    pub class: &'static Class,
    pub name: String,
    pub parent: Option<ObjectId>,
    pub cells: Cells,
    /// Cells by number, with what each was computed from.
    pub reads: Vec<(u16, Vec<CellKey>)>,
    /// The children, where their order is not that of their creation.
    pub order: Option<Vec<ObjectId>>,
}

impl Database {
    pub(crate) fn touch(&mut self, id: ObjectId) {
        if let Some(touched) = &mut self.touched {
            touched.insert(id);
        }
    }

    /// Notes from now on which objects change.
    pub fn watch(&mut self) {
        self.touched.get_or_insert_with(BTreeSet::new);
    }

    /// Objects that may have changed, come or gone since the last call; parents of those that came
    /// or moved are among them.
    pub fn take_touched(&mut self) -> BTreeSet<ObjectId> {
        let mut found = self.touched.as_mut().map(std::mem::take).unwrap_or_default();
        let parents: Vec<ObjectId> = found.iter().filter_map(|id| self.get(*id)?.parent).collect();
        found.extend(parents);
        found
    }

    /// Says that these objects are still to be written.
    pub fn touch_again(&mut self, objects: BTreeSet<ObjectId>) {
        if let Some(touched) = &mut self.touched {
            touched.extend(objects);
        }
    }

    /// A living object as plain data.
    pub fn stored(&self, id: ObjectId) -> Option<StoredObject> {
        let object = self.get(id)?;
        let reads = (0..object.class.cell_count()).filter_map(|cell| {
            let reads = self.reads(CellKey::new(id, cell));
            (!reads.is_empty()).then(|| (cell as u16, reads.to_vec()))
        });
        let order = (!object.children.is_sorted()).then(|| object.children.clone());
        Some(StoredObject {
            id,
            class: object.class,
            name: object.name.clone(),
            parent: object.parent,
            cells: object.cells.clone(),
            reads: reads.collect(),
            order,
        })
    }

    /// How many objects there have been.
    pub fn count_of_all(&self) -> usize {
        self.objects.len()
    }

    /// All systems of units that were in force.
    pub fn unit_systems(&self) -> &[UnitSystem] {
        &self.unit_systems
    }

    /// Puts a database together; it has no history.
    ///
    /// # Errors
    /// Where the pieces do not fit.
    pub fn restore(
        objects: Vec<StoredObject>,
        count: usize,
        roots: Option<Vec<ObjectId>>,
        settings: Settings,
        unit_systems: Vec<UnitSystem>,
    ) -> Result<Database, String> {
        if usize::from(settings.units.0) >= unit_systems.len() {
            return Err("the units in force are missing".into());
        }
        let mut database = Database { settings, unit_systems, ..Database::default() };
        if count > u32::MAX as usize || objects.iter().any(|o| o.id.0 as usize >= count) {
            return Err("an object has a number beyond the last".into());
        }
        database.objects.resize_with(count, || None);
        let mut places = Vec::with_capacity(objects.len());
        let mut orders = Vec::new();
        for stored in objects {
            let StoredObject { id, class, name, parent, cells, reads, order } = stored;
            if cells.iter().any(|(index, _)| index >= class.cell_count()) {
                return Err(format!("`{name}` does not have the cells of its class"));
            }
            let known = database.unit_systems.len();
            if cells.values().any(|c| usize::from(c.units.0) >= known) {
                return Err(format!("`{name}` has a value in units that are missing"));
            }
            for (cell, read) in reads {
                database.dependencies.replace(CellKey { object: id, cell }, read);
            }
            orders.extend(order.map(|o| (id, o)));
            places.push((id, parent));
            let slot = &mut database.objects[id.0 as usize];
            if slot.is_some() {
                return Err(format!("`{name}` has the number of another object"));
            }
            *slot = Some(Box::new(Object { class, name, parent, children: Vec::new(), cells }));
        }
        places.sort_unstable();
        for &(id, parent) in &places {
            if parent.is_some_and(|p| database.get(p).is_none()) || !database.ends_at_a_root(id, places.len()) {
                return Err("an object has no place in the tree".into());
            }
            database.names.insert(&database.objects, id);
            database.siblings(parent).push(id);
        }
        for (parent, order) in orders {
            database.reorder(Some(parent), order)?;
        }
        if let Some(order) = roots {
            database.reorder(None, order)?;
        }
        // Changes from here on are taken back one by one.
        database.flush_history();
        Ok(database)
    }

    fn ends_at_a_root(&self, id: ObjectId, most: usize) -> bool {
        let mut next = Some(id);
        for _ in 0..=most {
            match next.map(|id| self.get(id)) {
                None => return true,
                Some(None) => return false,
                Some(Some(object)) => next = object.parent,
            }
        }
        false
    }

    fn reorder(&mut self, parent: Option<ObjectId>, order: Vec<ObjectId>) -> Result<(), String> {
        let children = self.siblings(parent);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        if sorted != *children {
            return Err("the order of children does not name each of them once".into());
        }
        *children = order;
        Ok(())
    }
}

/// One node of an expression, behind the nodes it is made of: deep trees are flat in a file.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Step {
    Number {
        #[serde(with = "number")]
        value: f64,
        text: Box<str>,
        unit: Option<Box<str>>,
    },
    Text(String),
    Nothing,
    Constant(String),
    Object(ObjectId),
    Attribute(String),
    Index(usize),
    Call(Box<str>, usize),
    Unary(UnaryOperator),
    Binary(BinaryOperator),
    Conditional,
    Array(usize),
    Row(usize),
    Unbound(String),
}

impl From<Expression> for Vec<Step> {
    fn from(expression: Expression) -> Vec<Step> {
        let mut steps = Vec::new();
        flatten(expression.root, &mut steps);
        steps
    }
}

fn flatten(node: Node, steps: &mut Vec<Step>) {
    let all = |nodes: Vec<Node>, steps: &mut Vec<Step>| {
        let count = nodes.len();
        nodes.into_iter().for_each(|n| flatten(n, steps));
        count
    };
    let step = match node {
        Node::Number { value, text, unit } => Step::Number { value, text, unit },
        Node::Text(text) => Step::Text(text),
        Node::Nothing => Step::Nothing,
        Node::Constant(name) => Step::Constant(name.to_string()),
        Node::Object(id) => Step::Object(id),
        Node::Unbound(name) => Step::Unbound(name),
        Node::Attribute(of, name) => {
            flatten(*of, steps);
            Step::Attribute(name)
        }
        Node::Index(of, indices) => {
            flatten(*of, steps);
            Step::Index(all(indices, steps))
        }
        Node::Call { function, arguments } => Step::Call(function, all(arguments, steps)),
        Node::Unary(operator, of) => {
            flatten(*of, steps);
            Step::Unary(operator)
        }
        Node::Binary(operator, a, b) => {
            flatten(*a, steps);
            flatten(*b, steps);
            Step::Binary(operator)
        }
        Node::Conditional(a, b, c) => {
            flatten(*a, steps);
            flatten(*b, steps);
            flatten(*c, steps);
            Step::Conditional
        }
        Node::Array(nodes) => Step::Array(all(nodes, steps)),
        Node::Row(nodes) => Step::Row(all(nodes, steps)),
    };
    steps.push(step);
}

/// The names that are constants, as the tree holds them.
const CONSTANTS: [&str; 4] = ["PI", "DTOR", "RTOD", "TIME"];

impl TryFrom<Vec<Step>> for Expression {
    type Error = String;

    fn try_from(steps: Vec<Step>) -> Result<Expression, String> {
        let mut stack: Vec<Node> = Vec::new();
        for step in steps {
            let node = match step {
                Step::Number { value, text, unit } => Node::Number { value, text, unit },
                Step::Text(text) => Node::Text(text),
                Step::Nothing => Node::Nothing,
                Step::Constant(name) => match CONSTANTS.iter().find(|c| **c == name) {
                    Some(constant) => Node::Constant(constant),
                    None => return Err(format!("`{name}` is no constant")),
                },
                Step::Object(id) => Node::Object(id),
                Step::Unbound(name) => Node::Unbound(name),
                Step::Attribute(name) => Node::Attribute(Box::new(pop(&mut stack)?), name),
                Step::Index(count) => {
                    let indices = pop_many(&mut stack, count)?;
                    Node::Index(Box::new(pop(&mut stack)?), indices)
                }
                Step::Call(function, count) => Node::Call { function, arguments: pop_many(&mut stack, count)? },
                Step::Unary(operator) => Node::Unary(operator, Box::new(pop(&mut stack)?)),
                Step::Binary(operator) => {
                    let (b, a) = (pop(&mut stack)?, pop(&mut stack)?);
                    Node::Binary(operator, Box::new(a), Box::new(b))
                }
                Step::Conditional => {
                    let (c, b, a) = (pop(&mut stack)?, pop(&mut stack)?, pop(&mut stack)?);
                    Node::Conditional(Box::new(a), Box::new(b), Box::new(c))
                }
                Step::Array(count) => Node::Array(pop_many(&mut stack, count)?),
                Step::Row(count) => Node::Row(pop_many(&mut stack, count)?),
            };
            stack.push(node);
        }
        let root = pop(&mut stack)?;
        if stack.is_empty() { Ok(Expression { root }) } else { Err("an expression has two ends".into()) }
    }
}

fn pop(stack: &mut Vec<Node>) -> Result<Node, String> {
    stack.pop().ok_or_else(|| "an expression lacks a piece".to_string())
}

fn pop_many(stack: &mut Vec<Node>, count: usize) -> Result<Vec<Node>, String> {
    let from = stack.len().checked_sub(count).ok_or_else(|| "an expression lacks a piece".to_string())?;
    Ok(stack.split_off(from))
}

/// Numbers that texts like JSON cannot hold are written as words.
pub(crate) mod number {
    use serde::{Deserializer, Serializer, de};

    #[allow(clippy::trivially_copy_pass_by_ref)] // the signature serde wants
    pub fn serialize<S: Serializer>(x: &f64, to: S) -> Result<S::Ok, S::Error> {
        if x.is_finite() { to.serialize_f64(*x) } else { to.serialize_str(&x.to_string()) }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        from.deserialize_any(Visitor)
    }

    struct Visitor;

    impl de::Visitor<'_> for Visitor {
        type Value = f64;

        fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
            f.write_str("a number, or `inf`, `-inf`, `NaN`")
        }

        fn visit_f64<E: de::Error>(self, x: f64) -> Result<f64, E> {
            Ok(x)
        }

        fn visit_i64<E: de::Error>(self, x: i64) -> Result<f64, E> {
            Ok(x as f64)
        }

        fn visit_u64<E: de::Error>(self, x: u64) -> Result<f64, E> {
            Ok(x as f64)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<f64, E> {
            text.parse().map_err(|_| E::custom(format!("`{text}` is no number")))
        }
    }
}

/// A list of [`number`]s.
pub(crate) mod numbers {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(transparent)]
    struct One(#[serde(with = "super::number")] f64);

    pub fn serialize<S: Serializer>(list: &[f64], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(list.iter().map(|x| One(*x)))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
        Ok(Vec::<One>::deserialize(from)?.into_iter().map(|one| one.0).collect())
    }
}
