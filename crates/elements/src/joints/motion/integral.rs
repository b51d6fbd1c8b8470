//! Motions that prescribe a velocity or an acceleration: the displacement is its integral.
//!
//! Integrals from time 0 are kept at equally spaced knots and extended when a later time is asked
//! for. Between a knot and the time asked for an eighth-order Gauss rule is used, so the result
//! does not depend on the order of the questions.

use std::sync::{Mutex, PoisonError};

use equations::constraints::TimeFunction;

/// Distance of knots, s. Gauss' rule of four points is exact for polynomials of degree 7, so that a
/// smooth function of period 0.1 s is integrated to rounding.
const SPACING: f64 = 1e-3;

/// Displacement whose first or second derivative is a given function of time.
pub struct Integral<F> {
    rate: F,
    /// 1: the rate is a velocity; 2: an acceleration.
    order: usize,
    /// Velocity and displacement at knots `n * SPACING`.
    knots: Mutex<Vec<[f64; 2]>>,
}

impl<F: TimeFunction> Integral<F> {
    pub fn new(rate: F, order: usize, displacement: f64, velocity: f64) -> Self {
        Integral { rate, order, knots: Mutex::new(vec![[velocity, displacement]]) }
    }

    /// Velocity and displacement at `to` from those at `from`.
    fn advance(&self, from: f64, to: f64, [v, x]: [f64; 2]) -> [f64; 2] {
        const NODES: [f64; 2] = [0.339_981_043_584_856_3, 0.861_136_311_594_052_6];
        const WEIGHTS: [f64; 2] = [0.652_145_154_862_546_1, 0.347_854_845_137_453_86];
        let half = 0.5 * (to - from);
        let (mut area, mut moment) = (0.0, 0.0);
        for (node, weight) in NODES.into_iter().zip(WEIGHTS) {
            for at in [from + half * (1.0 - node), from + half * (1.0 + node)] {
                let f = self.rate.jet(at)[0];
                area += weight * half * f;
                moment += weight * half * f * (to - at);
            }
        }
        if self.order == 1 { [self.rate.jet(to)[0], x + area] } else { [v + area, x + v * (to - from) + moment] }
    }
}

impl<F: TimeFunction> TimeFunction for Integral<F> {
    fn jet(&self, t: f64) -> [f64; 3] {
        let wanted = (t.max(0.0) / SPACING).floor() as usize;
        let mut knots = self.knots.lock().unwrap_or_else(PoisonError::into_inner);
        while knots.len() <= wanted {
            let n = knots.len() - 1;
            let last = knots[n];
            let next = self.advance(n as f64 * SPACING, (n + 1) as f64 * SPACING, last);
            knots.push(next);
        }
        let knot = knots[wanted];
        drop(knots);
        let [v, x] = self.advance(wanted as f64 * SPACING, t, knot);
        let [rate, slope, _] = self.rate.jet(t);
        if self.order == 1 { [x, rate, slope] } else { [x, v, rate] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: the integral of cos is sin, of its second integral with start values x0 + v0 t + 1 -
    /// cos t. Gauss with four points on steps of 1 ms leaves rounding only.
    #[test]
    fn velocity_and_acceleration_are_integrated() {
        let cosine = |t: f64| [t.cos(), -t.sin(), -t.cos()];
        let from_velocity = Integral::new(cosine, 1, 0.5, 0.0);
        for t in [2.5_f64, 0.3, 1.000_5] {
            let [x, v, a] = from_velocity.jet(t);
            assert!((x - 0.5 - t.sin()).abs() < 1e-13 && (v - t.cos()).abs() < 1e-15 && (a + t.sin()).abs() < 1e-15);
        }
        let from_acceleration = Integral::new(cosine, 2, 0.5, 2.0);
        let [x, v, a] = from_acceleration.jet(1.7);
        assert!((x - (0.5 + 2.0 * 1.7 + 1.0 - 1.7_f64.cos())).abs() < 1e-12);
        assert!((v - (2.0 + 1.7_f64.sin())).abs() < 1e-12 && (a - 1.7_f64.cos()).abs() < 1e-15);
    }
}
