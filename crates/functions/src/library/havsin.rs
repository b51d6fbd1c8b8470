//! HAVSIN `(x, x0, h0, x1, h1)`: from `h0` at `x0` to `h1` at `x1` along half a sine wave.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Numeric, step::between};
use crate::tape::{Node, Tape, Unary};

pub(super) const ALL: &[Numeric] = &[Numeric {
    name: "HAVSIN",
    arguments: (5, 5),
    build: |t, a| between(t, [a[0], a[1], a[2], a[3], a[4]], half_wave),
}];

/// `(1 + sin(pi s - pi/2)) / 2`.
fn half_wave(tape: &mut Tape, s: Node) -> Node {
    let (angle, quarter) = (tape.scale(PI, s), tape.constant(FRAC_PI_2));
    let angle = tape.subtract(angle, quarter);
    let sine = tape.unary(Unary::Sin, angle);
    let half = tape.constant(0.5);
    let half_sine = tape.scale(0.5, sine);
    tape.add(half, half_sine)
}
