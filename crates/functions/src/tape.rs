//! The tape a function is compiled to, and its builder.
//!
//! A tape is a list of operations in an order in which operands come first. The library is written
//! in terms of the builder, so every function has exact derivatives from the few rules in
//! [`crate::rules`]. The builder folds constants and shares equal operations.

use std::collections::HashMap;

use crate::{Measure, rules};

/// Index of an operation of the tape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Node(pub u32);

/// Functions of one argument that have a derivative rule of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Unary {
    Negate,
    Abs,
    Sqrt,
    Exp,
    Log,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    /// Towards zero.
    Truncate,
    /// To the nearest integer, halves away from zero.
    Round,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    /// `atan2(first, second)`.
    Atan2,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    /// Index into the table of constants.
    Constant(u32),
    Time,
    Mode,
    /// Index into the list of measures.
    Measure(u32),
    Unary(Unary, Node),
    Binary(Binary, Node, Node),
    /// `IF(test: negative, zero, positive)`; every branching function is made of it.
    If {
        test: Node,
        negative: Node,
        zero: Node,
        positive: Node,
    },
}

impl Op {
    /// The operation with its operands renumbered.
    pub(crate) fn map(self, f: impl Fn(Node) -> Node) -> Op {
        match self {
            Op::Constant(_) | Op::Time | Op::Mode | Op::Measure(_) => self,
            Op::Unary(u, a) => Op::Unary(u, f(a)),
            Op::Binary(b, x, y) => Op::Binary(b, f(x), f(y)),
            Op::If { test, negative, zero, positive } => {
                Op::If { test: f(test), negative: f(negative), zero: f(zero), positive: f(positive) }
            }
        }
    }

    pub(crate) fn operands(self, mut visit: impl FnMut(Node)) {
        match self {
            Op::Constant(_) | Op::Time | Op::Mode | Op::Measure(_) => {}
            Op::Unary(_, a) => visit(a),
            Op::Binary(_, a, b) => {
                visit(a);
                visit(b);
            }
            Op::If { test, negative, zero, positive } => [test, negative, zero, positive].into_iter().for_each(visit),
        }
    }
}

/// Builds a tape.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    pub ops: Vec<Op>,
    pub constants: Vec<f64>,
    pub measures: Vec<Measure>,
    known: HashMap<Op, Node>,
    known_constants: HashMap<u64, u32>,
    known_measures: HashMap<Measure, u32>,
}

impl Tape {
    fn push(&mut self, op: Op) -> Node {
        let next = Node(self.ops.len() as u32);
        let node = *self.known.entry(op).or_insert(next);
        if node == next {
            self.ops.push(op);
        }
        node
    }

    pub fn constant(&mut self, x: f64) -> Node {
        let next = self.constants.len() as u32;
        let index = *self.known_constants.entry(x.to_bits()).or_insert(next);
        if index == next {
            self.constants.push(x);
        }
        self.push(Op::Constant(index))
    }

    pub fn time(&mut self) -> Node {
        self.push(Op::Time)
    }

    pub fn mode(&mut self) -> Node {
        self.push(Op::Mode)
    }

    pub fn measure(&mut self, measure: Measure) -> Node {
        let next = self.measures.len() as u32;
        let index = *self.known_measures.entry(measure).or_insert(next);
        if index == next {
            self.measures.push(measure);
        }
        self.push(Op::Measure(index))
    }

    /// The number a node always has, if it is one.
    pub fn known_value(&self, node: Node) -> Option<f64> {
        match self.ops.get(node.0 as usize)? {
            Op::Constant(index) => self.constants.get(*index as usize).copied(),
            _ => None,
        }
    }

    pub fn unary(&mut self, kind: Unary, a: Node) -> Node {
        match self.known_value(a) {
            Some(x) => self.constant(rules::unary(kind, x)),
            None => self.push(Op::Unary(kind, a)),
        }
    }

    pub fn binary(&mut self, kind: Binary, a: Node, b: Node) -> Node {
        match (self.known_value(a), self.known_value(b)) {
            (Some(x), Some(y)) => self.constant(rules::binary(kind, x, y)),
            _ => self.push(Op::Binary(kind, a, b)),
        }
    }

    /// `IF(test: negative, zero, positive)`.
    pub fn choose(&mut self, test: Node, negative: Node, zero: Node, positive: Node) -> Node {
        match self.known_value(test) {
            Some(x) if x < 0.0 => negative,
            Some(x) if x > 0.0 => positive,
            Some(0.0) => zero,
            _ => self.push(Op::If { test, negative, zero, positive }),
        }
    }

    pub fn negate(&mut self, a: Node) -> Node {
        self.unary(Unary::Negate, a)
    }

    pub fn add(&mut self, a: Node, b: Node) -> Node {
        self.binary(Binary::Add, a, b)
    }

    pub fn subtract(&mut self, a: Node, b: Node) -> Node {
        self.binary(Binary::Subtract, a, b)
    }

    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        self.binary(Binary::Multiply, a, b)
    }

    pub fn divide(&mut self, a: Node, b: Node) -> Node {
        self.binary(Binary::Divide, a, b)
    }

    /// `factor * a` with a plain number.
    pub fn scale(&mut self, factor: f64, a: Node) -> Node {
        let factor = self.constant(factor);
        self.multiply(factor, a)
    }

    /// `below` where `x < limit`, else `otherwise`.
    pub fn below(&mut self, x: Node, limit: Node, below: Node, otherwise: Node) -> Node {
        let test = self.subtract(x, limit);
        self.choose(test, below, otherwise, otherwise)
    }

    /// `a` where `a >= b`, else `b`.
    pub fn larger(&mut self, a: Node, b: Node) -> Node {
        self.below(a, b, b, a)
    }

    /// `a` where `a <= b`, else `b`.
    pub fn smaller(&mut self, a: Node, b: Node) -> Node {
        self.below(b, a, b, a)
    }

    /// What `root` needs, and nothing else.
    pub fn pruned(&self, root: Node) -> Tape {
        let mut needed = vec![false; self.ops.len()];
        if let Some(last) = needed.get_mut(root.0 as usize) {
            *last = true;
        }
        for index in (0..self.ops.len()).rev() {
            if needed[index] {
                self.ops[index].operands(|n| needed[n.0 as usize] = true);
            }
        }
        let mut kept = Tape::default();
        let mut renumbered = vec![Node(0); self.ops.len()];
        for (index, &op) in self.ops.iter().enumerate().filter(|(i, _)| needed[*i]) {
            renumbered[index] = match op {
                Op::Constant(c) => kept.constant(self.constants[c as usize]),
                Op::Measure(m) => kept.measure(self.measures[m as usize]),
                other => kept.push(other.map(|n| renumbered[n.0 as usize])),
            };
        }
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_fold_and_equal_operations_are_shared() {
        let mut tape = Tape::default();
        let (two, three) = (tape.constant(2.0), tape.constant(3.0));
        let six = tape.multiply(two, three);
        assert_eq!(tape.known_value(six), Some(6.0));
        let t = tape.time();
        let (a, b) = (tape.add(t, six), tape.add(t, six));
        assert_eq!(a, b);
    }

    #[test]
    fn pruning_keeps_only_what_the_result_needs() {
        let mut tape = Tape::default();
        let t = tape.time();
        let one = tape.constant(1.0);
        let unused = tape.add(t, one);
        let _ = tape.multiply(unused, unused);
        let root = tape.unary(Unary::Sin, t);
        let kept = tape.pruned(root);
        assert_eq!(kept.ops, [Op::Time, Op::Unary(Unary::Sin, Node(0))]);
        assert!(kept.constants.is_empty());
    }
}
