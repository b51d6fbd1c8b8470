//! The spring and damper about an axis as numbers. Equation numbers refer to `docs.md`.

use equations::Relative;

use crate::forces::{
    angles::{Branch, projected_angles, projected_angles_by_rotation},
    elastic::{Law, Response},
};

/// Constants of one spring and damper, SI.
#[derive(Debug, Default)]
pub struct Twist {
    pub stiffness: f64,
    pub damping: f64,
    /// Angle at which the torque is the preload.
    pub angle: f64,
    pub preload: f64,
    /// Whole turns of the angle.
    pub turns: Branch,
}

impl Twist {
    /// Angle from x of J to x of I about z of J, over any number of turns.
    fn turned(&self, motion: &Relative) -> f64 {
        self.turns.follow(projected_angles(&motion.rot_ji)[2]) - self.angle
    }
}

impl Law for Twist {
    /// (R.1) with its derivatives.
    fn response(&self, motion: &Relative) -> Response {
        let torque = self.preload - self.stiffness * self.turned(motion) - self.damping * motion.w_ji_j.z;
        let by_rotation = projected_angles_by_rotation(&motion.rot_ji)[2];
        let mut response = Response { load: [0.0; 6], by_position: [[0.0; 6]; 6], by_velocity: [[0.0; 6]; 6] };
        response.load[5] = torque;
        for (k, slope) in by_rotation.iter().enumerate() {
            response.by_position[5][3 + k] = -self.stiffness * slope;
        }
        response.by_velocity[5][5] = -self.damping;
        response
    }

    fn energy(&self, motion: &Relative) -> f64 {
        let turned = self.turned(motion);
        turned * (0.5 * self.stiffness * turned - self.preload)
    }
}

#[cfg(test)]
#[path = "tests/physics.rs"]
mod tests;
