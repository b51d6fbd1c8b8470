//! The spring and damper along a line as numbers. Equation numbers refer to `docs.md`.

use equations::Relative;
use glam::{DMat3, DVec3};

use crate::forces::elastic::{Law, Response};

/// Constants of one spring and damper, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub stiffness: f64,
    pub damping: f64,
    /// Distance at which the force is the preload.
    pub length: f64,
    pub preload: f64,
}

impl Line {
    /// Force that pushes I away from J (T.1): at a distance, with its rate.
    pub fn force(&self, distance: f64, rate: f64) -> f64 {
        self.preload - self.stiffness * (distance - self.length) - self.damping * rate
    }
}

impl Law for Line {
    /// (T.2) with its derivatives (T.3).
    fn response(&self, motion: &Relative) -> Response {
        let (d, v) = (motion.d_ji_j, motion.v_ji_j);
        let distance = d.length().max(f64::MIN_POSITIVE);
        let n = d / distance;
        let rate = v.dot(n);
        let force = self.force(distance, rate);
        let slope = n * -self.stiffness - (v - n * rate) * (self.damping / distance);
        let along = outer(n, n);
        let by_position = outer(n, slope) + (DMat3::IDENTITY - along) * (force / distance);
        let f = n * force;
        Response {
            load: [f.x, f.y, f.z, 0.0, 0.0, 0.0],
            by_position: corner(&by_position),
            by_velocity: corner(&(along * -self.damping)),
        }
    }

    fn energy(&self, motion: &Relative) -> f64 {
        let stretch = motion.d_ji_j.length() - self.length;
        stretch * (0.5 * self.stiffness * stretch - self.preload)
    }

    fn trouble(&self, motion: &Relative) -> Option<&'static str> {
        let lost = motion.d_ji_j == DVec3::ZERO && self.force(0.0, motion.v_ji_j.length()) != 0.0;
        lost.then_some("its markers coincide: the force has no direction")
    }
}

/// `a b^T`.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// Forces by displacements; nothing turns.
fn corner(block: &DMat3) -> [[f64; 6]; 6] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| if row < 3 && column < 3 { block.col(column)[row] } else { 0.0 })
    })
}

#[cfg(test)]
#[path = "tests/physics.rs"]
mod tests;
