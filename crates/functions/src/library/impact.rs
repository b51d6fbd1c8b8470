//! IMPACT and BISTOP: one-sided and two-sided contact of a point with a stop.
//!
//! The elastic part is `k p^e` with the penetration `p`; damping ramps from 0 to `cmax` over the
//! depth `d`; the sum never pulls.

use super::{Numeric, step::step};
use crate::tape::{Binary, Node, Tape};

pub(super) const ALL: &[Numeric] = &[
    Numeric { name: "IMPACT", arguments: (7, 7), build: impact },
    Numeric { name: "BISTOP", arguments: (8, 8), build: bistop },
];

/// `(x, xd, x1, k, e, cmax, d)`: pushes towards larger `x` where `x < x1`.
fn impact(tape: &mut Tape, a: &[Node]) -> Node {
    let zero = tape.constant(0.0);
    let push = lower_stop(tape, &Stop { x: a[0], rate: a[1], at: a[2], k: a[3], e: a[4], cmax: a[5], depth: a[6] });
    tape.below(a[0], a[2], push, zero)
}

/// `(x, xd, x1, x2, k, e, cmax, d)`: free between `x1` and `x2`.
fn bistop(tape: &mut Tape, a: &[Node]) -> Node {
    let [x, rate, x1, x2, k, e, cmax, depth] = [a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7]];
    let zero = tape.constant(0.0);
    let push = lower_stop(tape, &Stop { x, rate, at: x1, k, e, cmax, depth });
    // The upper stop is the lower one mirrored: x -> -x, force -> -force.
    let (minus_x, minus_rate, minus_x2) = (tape.negate(x), tape.negate(rate), tape.negate(x2));
    let pull = lower_stop(tape, &Stop { x: minus_x, rate: minus_rate, at: minus_x2, k, e, cmax, depth });
    let pull = tape.negate(pull);
    let not_below = tape.below(x2, x, pull, zero);
    tape.below(x, x1, push, not_below)
}

struct Stop {
    x: Node,
    rate: Node,
    at: Node,
    k: Node,
    e: Node,
    cmax: Node,
    depth: Node,
}

/// `max(0, k (at - x)^e - cmax rate STEP(x, at - depth, 1, at, 0))`, meant for `x < at`.
fn lower_stop(tape: &mut Tape, s: &Stop) -> Node {
    let (zero, one) = (tape.constant(0.0), tape.constant(1.0));
    let penetration = tape.subtract(s.at, s.x);
    let power = tape.binary(Binary::Power, penetration, s.e);
    let elastic = tape.multiply(s.k, power);
    let full = tape.subtract(s.at, s.depth);
    let share = step(tape, [s.x, full, one, s.at, zero]);
    let damping = tape.multiply(s.cmax, s.rate);
    let damping = tape.multiply(damping, share);
    let sum = tape.subtract(elastic, damping);
    tape.larger(zero, sum)
}
