use glam::{DMat3, DVec3};

use super::*;

fn bushing() -> Rates {
    Rates {
        stiffness: [100.0, 200.0, 300.0, 4.0, 5.0, 6.0],
        damping: [1.0, 2.0, 3.0, 0.4, 0.5, 0.6],
        preload: [7.0, 8.0, 9.0, 0.7, 0.8, 0.9],
        ..Rates::default()
    }
}

fn at(d: [f64; 3], rot: DMat3) -> Relative {
    Relative { d_ji_j: d.into(), rot_ji: rot, v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO }
}

/// Truth: the law by hand, one number at a time; no tolerance but that of the products.
#[test]
fn each_axis_has_its_own_spring_damper_and_preload() {
    let motion = Relative {
        v_ji_j: DVec3::new(2.0, -1.0, 0.5),
        w_ji_j: DVec3::new(1.0, 2.0, -3.0),
        ..at([0.1, -0.2, 0.3], DMat3::IDENTITY)
    };
    let expected = [7.0 - 10.0 - 2.0, 8.0 + 40.0 + 2.0, 9.0 - 90.0 - 1.5, 0.7 - 0.4, 0.8 - 1.0, 0.9 + 1.8];
    for (found, expected) in bushing().response(&motion).load.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-13, "{found} is not {expected}");
    }
}

/// Truth: turned by an angle about one axis, the angle about it is that angle and the others are 0.
#[test]
fn torques_follow_angles_about_one_axis() {
    let turns = [DMat3::from_rotation_x, DMat3::from_rotation_y, DMat3::from_rotation_z];
    for (k, turn) in turns.into_iter().enumerate() {
        let load = bushing().response(&at([0.0; 3], turn(0.4))).load;
        for m in 0..3 {
            let expected = bushing().preload[3 + m] - if m == k { 0.4 * bushing().stiffness[3 + m] } else { 0.0 };
            assert!((load[3 + m] - expected).abs() < 1e-14, "{k} {m}: {} is not {expected}", load[3 + m]);
        }
    }
}

/// Truth: half the stiffness times the square, less the work of the preload.
#[test]
fn energy_is_that_of_springs_and_preloads() {
    let energy = bushing().energy(&at([0.1, 0.0, 0.0], DMat3::from_rotation_z(0.5)));
    let expected = 0.5 * 100.0 * 0.01 - 7.0 * 0.1 + 0.5 * 6.0 * 0.25 - 0.9 * 0.5;
    assert!((energy - expected).abs() < 1e-14, "{energy} is not {expected}");
}

/// One axis may turn on and on; two large angles at once are named.
#[test]
fn turns_are_counted_and_two_large_angles_are_named() {
    let rates = bushing();
    for step in 0..=100 {
        let angle = 0.1 * f64::from(step);
        let load = rates.response(&at([0.0; 3], DMat3::from_rotation_z(angle))).load;
        assert!((load[5] - (0.9 - 6.0 * angle)).abs() < 1e-12, "at {angle}: {}", load[5]);
    }
    assert!(rates.concern(&at([0.0; 3], DMat3::from_rotation_z(1.0))).is_none());
    let both = DMat3::from_rotation_x(0.5) * DMat3::from_rotation_y(0.4);
    assert!(rates.concern(&at([0.0; 3], both)).is_some_and(|c| c.size > 10.0));
}
