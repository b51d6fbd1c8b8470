//! STEP and STEP5 `(x, x0, h0, x1, h1)`: from `h0` at `x0` to `h1` at `x1` by a polynomial with flat
//! ends.

use super::Numeric;
use crate::tape::{Node, Tape};

pub(super) const ALL: &[Numeric] = &[
    Numeric { name: "STEP", arguments: (5, 5), build: |t, a| step(t, [a[0], a[1], a[2], a[3], a[4]]) },
    Numeric { name: "STEP5", arguments: (5, 5), build: |t, a| step5(t, [a[0], a[1], a[2], a[3], a[4]]) },
];

/// `h0 + (h1 - h0) s^2 (3 - 2 s)`, `s = (x - x0) / (x1 - x0)`, between the ends.
pub(super) fn step(tape: &mut Tape, arguments: [Node; 5]) -> Node {
    between(tape, arguments, cubic)
}

/// `h0 + (h1 - h0) s^3 (10 - 15 s + 6 s^2)` between the ends.
pub(super) fn step5(tape: &mut Tape, arguments: [Node; 5]) -> Node {
    between(tape, arguments, quintic)
}

/// `h0` up to `x0`, `h1` from `x1`, and in between `h0 + (h1 - h0) shape(s)`. Ends given in falling
/// order are swapped together with their heights.
pub(super) fn between(tape: &mut Tape, [x, x0, h0, x1, h1]: [Node; 5], shape: fn(&mut Tape, Node) -> Node) -> Node {
    let order = tape.subtract(x1, x0);
    let rising = rise(tape, [x, x0, h0, x1, h1], shape);
    if tape.known_value(order).is_some_and(|d| d >= 0.0) {
        return rising;
    }
    let falling = rise(tape, [x, x1, h1, x0, h0], shape);
    tape.choose(order, falling, rising, rising)
}

fn rise(tape: &mut Tape, [x, x0, h0, x1, h1]: [Node; 5], shape: fn(&mut Tape, Node) -> Node) -> Node {
    let (way, width, height) = (tape.subtract(x, x0), tape.subtract(x1, x0), tape.subtract(h1, h0));
    let s = tape.divide(way, width);
    let share = shape(tape, s);
    let gain = tape.multiply(height, share);
    let inside = tape.add(h0, gain);
    let upper = tape.below(x, x1, inside, h1);
    tape.choose(way, h0, h0, upper)
}

fn cubic(tape: &mut Tape, s: Node) -> Node {
    let three = tape.constant(3.0);
    let double = tape.scale(2.0, s);
    let rest = tape.subtract(three, double);
    let square = tape.multiply(s, s);
    tape.multiply(square, rest)
}

/// `s^3 (10 - 15 s + 6 s^2)`.
fn quintic(tape: &mut Tape, s: Node) -> Node {
    let square = tape.multiply(s, s);
    let cube = tape.multiply(square, s);
    let (ten, linear, quadratic) = (tape.constant(10.0), tape.scale(15.0, s), tape.scale(6.0, square));
    let rest = tape.subtract(ten, linear);
    let rest = tape.add(rest, quadratic);
    tape.multiply(cube, rest)
}
