//! SHF `(x, x0, a, w, phi, b)`: simple harmonic function `a sin(w (x - x0) - phi) + b`.

use super::Numeric;
use crate::tape::{Node, Tape, Unary};

pub(super) const ALL: &[Numeric] = &[Numeric { name: "SHF", arguments: (6, 6), build: shf }];

fn shf(tape: &mut Tape, a: &[Node]) -> Node {
    let way = tape.subtract(a[0], a[1]);
    let angle = tape.multiply(a[3], way);
    let angle = tape.subtract(angle, a[4]);
    let sine = tape.unary(Unary::Sin, angle);
    let wave = tape.multiply(a[2], sine);
    tape.add(wave, a[5])
}
