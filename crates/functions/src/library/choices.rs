//! Functions that choose between values: IF, MIN, MAX, DIM, SIGN, MOD. Their derivative is that of
//! the value chosen.

use super::Numeric;
use crate::tape::{Node, Tape, Unary};

pub(super) const ALL: &[Numeric] = &[
    // IF(test: negative, zero, positive)
    Numeric { name: "IF", arguments: (4, 4), build: |t, a| t.choose(a[0], a[1], a[2], a[3]) },
    Numeric { name: "MAX", arguments: (2, 2), build: |t, a| t.larger(a[0], a[1]) },
    Numeric { name: "MIN", arguments: (2, 2), build: |t, a| t.smaller(a[0], a[1]) },
    Numeric { name: "DIM", arguments: (2, 2), build: dim },
    Numeric { name: "SIGN", arguments: (2, 2), build: sign },
    Numeric { name: "MOD", arguments: (2, 2), build: modulo },
];

/// `max(a - b, 0)`.
fn dim(tape: &mut Tape, a: &[Node]) -> Node {
    let difference = tape.subtract(a[0], a[1]);
    let zero = tape.constant(0.0);
    tape.larger(difference, zero)
}

/// `|a|` with the sign of `b`; 0 counts as positive.
fn sign(tape: &mut Tape, a: &[Node]) -> Node {
    let size = tape.unary(Unary::Abs, a[0]);
    let negative = tape.negate(size);
    tape.choose(a[1], negative, size, size)
}

/// `a - AINT(a / b) b`: has the sign of `a`.
fn modulo(tape: &mut Tape, a: &[Node]) -> Node {
    let ratio = tape.divide(a[0], a[1]);
    let whole = tape.unary(Unary::Truncate, ratio);
    let product = tape.multiply(whole, a[1]);
    tape.subtract(a[0], product)
}
