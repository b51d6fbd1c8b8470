use glam::{DMat3, DVec3};

use super::*;

fn at(angle: f64, w: f64) -> Relative {
    Relative {
        d_ji_j: DVec3::ZERO,
        rot_ji: DMat3::from_rotation_z(angle),
        v_ji_j: DVec3::ZERO,
        w_ji_j: DVec3::new(0.0, 0.0, w),
    }
}

/// Truth: the law by hand, for more than one turn.
#[test]
fn the_torque_follows_the_angle_over_turns() {
    let spring = Twist { stiffness: 10.0, damping: 2.0, angle: 0.3, preload: 4.0, ..Twist::default() };
    for step in 0..=100 {
        let angle = 0.1 * f64::from(step);
        let load = spring.response(&at(angle, 1.5)).load;
        let expected = 4.0 - 10.0 * (angle - 0.3) - 3.0;
        assert!((load[5] - expected).abs() < 1e-12, "at {angle}: {} is not {expected}", load[5]);
        assert!(load[..5].iter().all(|x| *x == 0.0));
    }
    // 10 rad: half the stiffness times the square, less the work of the preload.
    let energy = spring.energy(&at(10.0, 0.0));
    assert!((energy - (5.0 * 9.7 * 9.7 - 4.0 * 9.7)).abs() < 1e-10, "{energy}");
}
