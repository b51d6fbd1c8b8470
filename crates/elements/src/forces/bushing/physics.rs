//! The bushing as numbers. Equation numbers refer to `docs.md`.

use equations::{Concern, Relative};

use crate::forces::{
    angles::{Branch, projected_angles, projected_angles_by_rotation},
    elastic::{Law, Response},
};

/// Angles of which two may not be larger at once, rad (10 degrees): they disturb each other.
pub const SMALL_ANGLE: f64 = std::f64::consts::PI / 18.0;

/// Constants of one bushing, SI: along x, y, z of J, then about them.
#[derive(Debug, Default)]
pub struct Rates {
    pub stiffness: [f64; 6],
    pub damping: [f64; 6],
    /// Load on I without displacement and motion.
    pub preload: [f64; 6],
    /// Whole turns of the three angles.
    pub turns: [Branch; 3],
}

impl Rates {
    /// Displacement and angles of I in J (B.1).
    fn deformation(&self, motion: &Relative) -> [f64; 6] {
        let r = motion.d_ji_j;
        let angles = projected_angles(&motion.rot_ji);
        let [a, b, c] = std::array::from_fn(|k| self.turns[k].follow(angles[k]));
        [r.x, r.y, r.z, a, b, c]
    }
}

impl Law for Rates {
    /// (B.2) with its derivatives (B.3).
    fn response(&self, motion: &Relative) -> Response {
        let q = self.deformation(motion);
        let (v, w) = (motion.v_ji_j, motion.w_ji_j);
        let rate = [v.x, v.y, v.z, w.x, w.y, w.z];
        let load = std::array::from_fn(|k| self.preload[k] - self.stiffness[k] * q[k] - self.damping[k] * rate[k]);
        let by_rotation = projected_angles_by_rotation(&motion.rot_ji);
        let (mut by_position, mut by_velocity) = ([[0.0; 6]; 6], [[0.0; 6]; 6]);
        for k in 0..6 {
            by_velocity[k][k] = -self.damping[k];
            if k < 3 {
                by_position[k][k] = -self.stiffness[k];
            } else {
                for column in 0..3 {
                    by_position[k][3 + column] = -self.stiffness[k] * by_rotation[k - 3][column];
                }
            }
        }
        Response { load, by_position, by_velocity }
    }

    fn energy(&self, motion: &Relative) -> f64 {
        let q = self.deformation(motion);
        (0..6).map(|k| q[k] * (0.5 * self.stiffness[k] * q[k] - self.preload[k])).sum()
    }

    fn concern(&self, motion: &Relative) -> Option<Concern> {
        if self.stiffness[3..].iter().all(|k| *k == 0.0) {
            return None;
        }
        let mut angles = projected_angles(&motion.rot_ji).map(f64::abs);
        angles.sort_by(f64::total_cmp);
        let sentence = "turned about two axes at once beyond what the angles of a bushing describe";
        (angles[1] > SMALL_ANGLE).then_some(Concern {
            sentence,
            size: angles[1].to_degrees(),
            unit: "degrees",
            pieces: None,
        })
    }
}

#[cfg(test)]
#[path = "tests/physics.rs"]
mod tests;
