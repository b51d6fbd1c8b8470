//! Angles of projected axes, which beams and bushings measure relative rotations with.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use equations::measures::nearest;
use glam::DMat3;

/// Angles about x, y, z of J from projected axes of I, rad.
pub fn projected_angles(rot_ji: &DMat3) -> [f64; 3] {
    let (x, z) = (rot_ji.x_axis, rot_ji.z_axis);
    [(-z.y).atan2(z.z), z.x.atan2(z.z), x.y.atan2(x.x)]
}

/// Derivative of [`projected_angles`] by a small rotation of I in J axes.
pub fn projected_angles_by_rotation(rot_ji: &DMat3) -> [[f64; 3]; 3] {
    let (x, z) = (rot_ji.x_axis, rot_ji.z_axis);
    // The projections vanish only where an angle is undefined; the load is a jump there anyway.
    let [yz, xz, xy] =
        [z.y * z.y + z.z * z.z, z.x * z.x + z.z * z.z, x.x * x.x + x.y * x.y].map(|square: f64| square.max(1e-30));
    [
        [1.0, -z.x * z.y / yz, -z.x * z.z / yz],
        [-z.y * z.x / xz, 1.0, -z.y * z.z / xz],
        [-x.z * x.x / xy, -x.z * x.y / xy, 1.0],
    ]
}

/// The whole turns of an angle that the rotation alone does not tell: each new value is taken as near
/// to the one before as possible.
#[derive(Debug, Default)]
pub struct Branch(AtomicU64);

impl Branch {
    /// The angle with its turns, which the next one is compared with.
    pub fn follow(&self, angle: f64) -> f64 {
        let angle = nearest(angle, f64::from_bits(self.0.load(Relaxed)));
        self.0.store(angle.to_bits(), Relaxed);
        angle
    }
}
