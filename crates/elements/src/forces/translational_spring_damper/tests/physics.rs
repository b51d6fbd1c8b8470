use super::*;

const SPRING: Line = Line { stiffness: 100.0, damping: 3.0, length: 4.0, preload: 20.0 };

fn at(d: [f64; 3], v: [f64; 3]) -> Relative {
    Relative { d_ji_j: d.into(), rot_ji: DMat3::IDENTITY, v_ji_j: v.into(), w_ji_j: DVec3::ZERO }
}

/// Truth: 3, 4, 5 by hand: 1 too long pulls with 100, the preload pushes with 20, and of the velocity
/// (5, 0, 0) the part 3 along the line is damped.
#[test]
fn the_force_is_along_the_line() {
    let load = SPRING.response(&at([3.0, 4.0, 0.0], [5.0, 0.0, 0.0])).load;
    let force = 20.0 - 100.0 - 9.0;
    for (found, expected) in load.into_iter().zip([0.6 * force, 0.8 * force, 0.0, 0.0, 0.0, 0.0]) {
        assert!((found - expected).abs() < 1e-13, "{found} is not {expected}");
    }
}

/// Truth: half the stiffness times the square of the stretch, less the work of the preload.
#[test]
fn energy_is_that_of_spring_and_preload() {
    assert!((SPRING.energy(&at([3.0, 4.0, 0.0], [0.0; 3])) - (50.0 - 20.0)).abs() < 1e-13);
}

#[test]
fn coincident_markers_have_no_direction() {
    assert!(SPRING.trouble(&at([0.0; 3], [0.0; 3])).is_some());
    assert!(SPRING.trouble(&at([1e-9, 0.0, 0.0], [0.0; 3])).is_none());
    // A spring of free length 0 has no force there, so that no direction is wanted.
    let slack = Line { length: 0.0, preload: 0.0, ..SPRING };
    assert!(slack.trouble(&at([0.0; 3], [0.0; 3])).is_none());
    assert!(slack.response(&at([0.0; 3], [0.0; 3])).load.iter().all(|x| *x == 0.0));
}
