//! SWEEP `(x, a, x0, f0, x1, f1, dx)`: a sine whose frequency (cycles per unit of `x`) grows linearly
//! from `f0` at `x0` to `f1` at `x1` and is constant outside. The phase is continuous.
//!
//! `STEP5(x, 0, 0, dx, 1) a sin(2 pi n(x))` with the number of cycles `n` counted from `x = 0`; the
//! ramp to full amplitude begins at `x = 0`, not at `x0` (as help.solidworks.com documents it for the
//! Adams solver built into SolidWorks Motion).

use std::f64::consts::TAU;

use super::{Numeric, step::step5};
use crate::tape::{Node, Tape, Unary};

pub(super) const ALL: &[Numeric] = &[Numeric { name: "SWEEP", arguments: (7, 7), build: sweep }];

fn sweep(tape: &mut Tape, arguments: &[Node]) -> Node {
    let [x, a, x0, f0, x1, f1, dx] = [0, 1, 2, 3, 4, 5, 6].map(|i| arguments[i]);
    let (zero, one) = (tape.constant(0.0), tape.constant(1.0));

    let before = tape.multiply(f0, x);
    // f0 x + (f1 - f0) (x - x0)^2 / (2 (x1 - x0))
    let (gain, width, way) = (tape.subtract(f1, f0), tape.subtract(x1, x0), tape.subtract(x, x0));
    let rate = tape.divide(gain, width);
    let half_rate = tape.scale(0.5, rate);
    let square = tape.multiply(way, way);
    let extra = tape.multiply(half_rate, square);
    let during = tape.add(before, extra);
    // f1 x - (f1 - f0) (x1 + x0) / 2
    let (fast, ends) = (tape.multiply(f1, x), tape.add(x0, x1));
    let half_gain = tape.scale(0.5, gain);
    let lag = tape.multiply(half_gain, ends);
    let after = tape.subtract(fast, lag);

    let late = tape.below(x, x1, during, after);
    let cycles = tape.below(x, x0, before, late);
    let angle = tape.scale(TAU, cycles);
    let sine = tape.unary(Unary::Sin, angle);
    let wave = tape.multiply(a, sine);
    let ramp = step5(tape, [x, zero, zero, dx, one]);
    tape.multiply(ramp, wave)
}
