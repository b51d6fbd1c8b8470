//! Twins: objects made once more, with everything below them, that refer to each other as the
//! originals do.

use std::collections::HashMap;

use model::{Cell, CellKey, Expression, FunctionText, Node, ObjectId, Piece, Source, Value};

use super::shared::Outcome;
use crate::{Interpreter, lookup, lookup::NewName};

/// Twin by original.
pub type Twins = HashMap<ObjectId, ObjectId>;

impl Interpreter {
    /// Makes twins of objects and all below them. `known` are originals that have a twin already:
    /// what refers to them will refer to that.
    pub(crate) fn make_twins(
        &mut self,
        originals: &[(ObjectId, NewName)],
        known: Twins,
        typed: &str,
        span: text::Span,
    ) -> Outcome<Twins> {
        let mut twins = known;
        let mut sources = Vec::new();
        for (root, place) in originals {
            for source in self.database.subtree(*root) {
                let object = self.database.object(source);
                let class = object.class;
                let (parent, name) = if source == *root {
                    (place.parent, place.name.clone())
                } else {
                    (object.parent.and_then(|p| twins.get(&p).copied()), object.name.clone())
                };
                let twin = self
                    .database
                    .create(class, parent, &name)
                    .map_err(|t| vec![lookup::taken(&self.database, class, typed, t.0, span)])?;
                twins.insert(source, twin);
                sources.push(source);
            }
        }
        for source in sources {
            self.fill_twin(source, &twins);
        }
        self.names.forget();
        Ok(twins)
    }

    fn fill_twin(&mut self, source: ObjectId, twins: &Twins) {
        let Some(&twin) = twins.get(&source) else { return };
        for (index, cell) in self.database.object(source).cells.clone().iter() {
            let reads = self.database.reads(CellKey::new(source, index)).to_vec();
            let reads = reads.iter().map(|r| CellKey { object: *twins.get(&r.object).unwrap_or(&r.object), ..*r });
            let reads = reads.collect();
            // A number in the solver's files belongs to one object; that of the ground is always the same.
            let class = self.database.object(source).class;
            let own_id = class.field(index).name == "adams_id" && class.id != "ground";
            let cell = if own_id {
                Cell { value: Value::Integer(0), source: Source::Literal, ..cell.clone() }
            } else {
                moved_cell(cell, twins)
            };
            let key = CellKey::new(twin, index);
            self.database.set_reads(key, reads);
            self.database.set_cell(key, Some(cell));
        }
    }

    /// A name below a parent that nothing has: as wanted, or with `_2`, `_3`, ... behind it.
    pub(crate) fn free_name(&self, parent: Option<ObjectId>, wanted: &str) -> String {
        let mut name = wanted.to_string();
        let mut number = 2;
        while !self.database.children_named(parent, &name).is_empty() {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        name
    }
}

fn moved_cell(cell: &Cell, twins: &Twins) -> Cell {
    let at = |id: &ObjectId| *twins.get(id).unwrap_or(id);
    let value = match &cell.value {
        Value::Object(id) => Value::Object(at(id)),
        Value::Objects(ids) => Value::Objects(ids.iter().map(at).collect()),
        Value::Function(f) => Value::Function(FunctionText {
            pieces: f
                .pieces
                .iter()
                .map(|p| match p {
                    Piece::Object(id) => Piece::Object(at(id)),
                    Piece::Text(text) => Piece::Text(text.clone()),
                })
                .collect(),
        }),
        other => other.clone(),
    };
    let source = match &cell.source {
        Source::Literal => Source::Literal,
        Source::Expression(e) => Source::Expression(Box::new(Expression { root: moved_node(&e.root, &at) })),
        Source::Elements(list) => {
            let moved = |e: &Option<Expression>| e.as_ref().map(|e| Expression { root: moved_node(&e.root, &at) });
            Source::Elements(Box::new(list.iter().map(moved).collect()))
        }
    };
    Cell { value, units: cell.units, source }
}

fn moved_node(node: &Node, at: &impl Fn(&ObjectId) -> ObjectId) -> Node {
    let one = |n: &Node| Box::new(moved_node(n, at));
    let all = |list: &[Node]| list.iter().map(|n| moved_node(n, at)).collect();
    match node {
        Node::Object(id) => Node::Object(at(id)),
        Node::Attribute(inner, name) => Node::Attribute(one(inner), name.clone()),
        Node::Index(inner, list) => Node::Index(one(inner), all(list)),
        Node::Call { function, arguments } => Node::Call { function: function.clone(), arguments: all(arguments) },
        Node::Unary(op, a) => Node::Unary(*op, one(a)),
        Node::Binary(op, a, b) => Node::Binary(*op, one(a), one(b)),
        Node::Conditional(a, b, c) => Node::Conditional(one(a), one(b), one(c)),
        Node::Array(list) => Node::Array(all(list)),
        Node::Row(list) => Node::Row(all(list)),
        other => other.clone(),
    }
}
