//! Polynomials and Fourier series in `u = x - x0` with up to 31 coefficients.

use super::Numeric;
use crate::tape::{Node, Tape, Unary};

pub(super) const ALL: &[Numeric] = &[
    // POLY(x, x0, a0, a1, ...) = sum of a_j u^j
    Numeric { name: "POLY", arguments: (3, 33), build: poly },
    // CHEBY(x, x0, a0, a1, ...) = sum of a_j T_j(u), Chebyshev polynomials
    Numeric { name: "CHEBY", arguments: (3, 33), build: cheby },
    // FORCOS(x, x0, w, a0, a1, ...) = sum of a_j cos(j w u)
    Numeric { name: "FORCOS", arguments: (4, 34), build: |t, a| fourier(t, a, Unary::Cos) },
    // FORSIN(x, x0, w, a0, a1, ...) = a0 + sum of a_j sin(j w u), j from 1
    Numeric { name: "FORSIN", arguments: (4, 34), build: |t, a| fourier(t, a, Unary::Sin) },
];

/// Horner's scheme.
fn poly(tape: &mut Tape, a: &[Node]) -> Node {
    let u = tape.subtract(a[0], a[1]);
    let mut sum = tape.constant(0.0);
    for (count, &coefficient) in a[2..].iter().rev().enumerate() {
        sum = if count == 0 {
            coefficient
        } else {
            let product = tape.multiply(sum, u);
            tape.add(product, coefficient)
        };
    }
    sum
}

/// `T_0 = 1`, `T_1 = u`, `T_j = 2 u T_(j-1) - T_(j-2)`.
fn cheby(tape: &mut Tape, a: &[Node]) -> Node {
    let u = tape.subtract(a[0], a[1]);
    let double = tape.scale(2.0, u);
    let (mut before, mut polynomial) = (u, tape.constant(1.0));
    let mut sum = a[2];
    for (j, &coefficient) in a.iter().enumerate().skip(3) {
        let next = if j == 3 {
            u
        } else {
            let product = tape.multiply(double, polynomial);
            tape.subtract(product, before)
        };
        (before, polynomial) = (polynomial, next);
        let term = tape.multiply(coefficient, polynomial);
        sum = tape.add(sum, term);
    }
    sum
}

fn fourier(tape: &mut Tape, a: &[Node], wave: Unary) -> Node {
    let u = tape.subtract(a[0], a[1]);
    let angle = tape.multiply(a[2], u);
    let mut sum = a[3];
    for (j, &coefficient) in a[4..].iter().enumerate() {
        let angle = tape.scale((j + 1) as f64, angle);
        let wave = tape.unary(wave, angle);
        let term = tape.multiply(coefficient, wave);
        sum = tape.add(sum, term);
    }
    sum
}
