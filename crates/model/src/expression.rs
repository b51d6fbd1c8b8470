//! Expressions bound to objects. Names are held as references, so an expression follows a
//! renaming; `expressions` parses, evaluates and prints them.

use serde::{Deserialize, Serialize};

use crate::{ObjectId, stored};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum UnaryOperator {
    Negate,
    Plus,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum BinaryOperator {
    Power,
    Multiply,
    Divide,
    Add,
    Subtract,
    Concatenate,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// One node of an expression tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A number as typed; `text` keeps its digits, `unit` the unit expression behind it
    /// (`inch`, `(kg/meter**3)`, `d`).
    Number {
        value: f64,
        text: Box<str>,
        unit: Option<Box<str>>,
    },
    Text(String),
    /// `(none)`.
    Nothing,
    /// PI, DTOR, RTOD, TIME.
    Constant(&'static str),
    Object(ObjectId),
    /// `.model.part.marker.location`: an attribute of an object-valued node.
    Attribute(Box<Node>, String),
    /// `name[i]`, from 1.
    Index(Box<Node>, Vec<Node>),
    Call {
        function: Box<str>,
        arguments: Vec<Node>,
    },
    Unary(UnaryOperator, Box<Node>),
    Binary(BinaryOperator, Box<Node>, Box<Node>),
    Conditional(Box<Node>, Box<Node>, Box<Node>),
    /// `{1, 2, 3}` and nested forms.
    Array(Vec<Node>),
    /// `[1, 2]` inside braces: one row of a matrix.
    Row(Vec<Node>),
    /// A name that was not bound to an object when the expression was read.
    Unbound(String),
}

impl Node {
    /// Calls `visit` on this node and all below it.
    pub fn walk(&self, visit: &mut impl FnMut(&Node)) {
        visit(self);
        match self {
            Node::Attribute(inner, _) | Node::Unary(_, inner) => inner.walk(visit),
            Node::Index(inner, indices) => {
                inner.walk(visit);
                for n in indices {
                    n.walk(visit);
                }
            }
            Node::Call { arguments: list, .. } | Node::Array(list) | Node::Row(list) => {
                for n in list {
                    n.walk(visit);
                }
            }
            Node::Binary(_, a, b) => {
                a.walk(visit);
                b.walk(visit);
            }
            Node::Conditional(a, b, c) => {
                a.walk(visit);
                b.walk(visit);
                c.walk(visit);
            }
            Node::Number { .. }
            | Node::Text(_)
            | Node::Nothing
            | Node::Constant(_)
            | Node::Object(_)
            | Node::Unbound(_) => {}
        }
    }
}

/// A kept expression.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "Vec<stored::Step>", try_from = "Vec<stored::Step>")]
pub struct Expression {
    pub root: Node,
}

impl Expression {
    /// Every object the expression names.
    pub fn objects(&self) -> Vec<ObjectId> {
        let mut found = Vec::new();
        self.root.walk(&mut |n| {
            if let Node::Object(id) = n {
                found.push(*id);
            }
        });
        found
    }
}
