//! Beam physics against closed forms, printed numbers and difference quotients.

use super::*;

fn section() -> Section {
    // The numbers of the help page's example.
    Section { length: 2.0, area: 1.5, ixx: 4.0, iyy: 2.0, izz: 3.0, e: 0.4, g: 0.2, asy: 0.9, asz: 0.8 }
}

fn law(formulation: Formulation, angles: Angles) -> Law {
    let k = stiffness(&section());
    let mut terms = [0.0; 21];
    for (n, term) in terms.iter_mut().enumerate() {
        *term = 0.01 * (1.0 + n as f64) + if [0, 6, 11, 15, 18, 20].contains(&n) { 1.0 } else { 0.0 };
    }
    Law { length: 2.0, stiffness: k, damping: from_lower_triangle(&terms), formulation, angles }
}

/// A motion with rotations of the given size.
fn motion(size: f64) -> Relative {
    Relative {
        d_ji_j: DVec3::new(2.1, 0.3, -0.2),
        rot_ji: DMat3::from_axis_angle(DVec3::new(0.5, -0.7, 0.4).normalize(), size),
        v_ji_j: DVec3::new(0.3, -0.2, 0.7),
        w_ji_j: DVec3::new(-0.4, 0.6, 0.1),
    }
}

fn assert_close(actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() <= tolerance, "{actual} is not {expected} within {tolerance}");
}

/// Truth: 12 E I ASY / (G A L^2) and the entries of the help page's matrix by exact arithmetic
/// (for instance Py = 12 * 0.4 * 3 * 0.9 / (0.2 * 1.5 * 4) = 10.8); ten printed digits.
#[test]
fn stiffness_of_the_help_page_example() {
    let (py, pz) = shear_corrections(&section());
    assert_close(py, 10.8, 1e-14);
    assert_close(pz, 6.4, 1e-14);
    let k = stiffness(&section());
    let expected = [
        (0, 0, 0.3),
        (1, 1, 0.1525423729),
        (1, 5, -0.1525423729),
        (2, 2, 0.1621621622),
        (2, 4, 0.1621621622),
        (3, 3, 0.4),
        (4, 4, 0.5621621622),
        (5, 5, 0.7525423729),
    ];
    for (row, column, value) in expected {
        assert_close(k[row][column], value, 5e-11);
        assert_eq!(k[row][column], k[column][row]);
    }
    let printed = expected.iter().map(|e| if e.0 == e.1 { 1 } else { 2 }).sum::<usize>();
    assert_eq!(k.iter().flatten().filter(|x| **x != 0.0).count(), printed);
    assert_close(proportional_damping(&k, 2.0)[1][5], 2.0 * k[1][5], 0.0);
}

/// Truth: Timoshenko cantilever, y = P L^3/3EI + ASY P L/GA with slope P L^2/2EI under a tip force,
/// y = M L^2/2EI with slope M L/EI under a tip moment; deflection along z turns by -b.
#[test]
fn tip_loads_bend_like_a_cantilever() {
    let s = section();
    let k = stiffness(&s);
    let (p, m, l) = (0.7, 0.3, s.length);
    let ei = s.e * s.izz;
    let y = p * l.powi(3) / (3.0 * ei) + s.asy * p * l / (s.g * s.area) + m * l * l / (2.0 * ei);
    let c = p * l * l / (2.0 * ei) + m * l / ei;
    assert_close(k[1][1] * y + k[1][5] * c, p, 1e-14);
    assert_close(k[5][1] * y + k[5][5] * c, m, 1e-14);
    let ei = s.e * s.iyy;
    let z = p * l.powi(3) / (3.0 * ei) + s.asz * p * l / (s.g * s.area) - m * l * l / (2.0 * ei);
    let b = -p * l * l / (2.0 * ei) + m * l / ei;
    assert_close(k[2][2] * z + k[2][4] * b, p, 1e-14);
    assert_close(k[4][2] * z + k[4][4] * b, m, 1e-14);
}

#[test]
fn no_load_where_undeformed() {
    let rest = Relative {
        d_ji_j: DVec3::new(2.0, 0.0, 0.0),
        rot_ji: DMat3::IDENTITY,
        v_ji_j: DVec3::ZERO,
        w_ji_j: DVec3::ZERO,
    };
    for formulation in [Formulation::Linear, Formulation::String] {
        assert_eq!(law(formulation, Angles::Projected).load(&rest).map(f64::abs), [0.0; 6]);
        assert_eq!(law(formulation, Angles::RotationVector).energy(&rest), 0.0);
    }
}

/// Truth: turning by one angle only makes that angle, in either measure and past 90 degrees.
#[test]
fn one_angle_is_measured_exactly() {
    for angle in [-2.5, -0.3, 1e-10, 0.2, 1.4, 3.0] {
        for (axis, rot) in [DMat3::from_rotation_x(angle), DMat3::from_rotation_y(angle), DMat3::from_rotation_z(angle)]
            .into_iter()
            .enumerate()
        {
            // The other projected angles stay 0 while this one is below 90 degrees.
            if angle.abs() < 1.5 || axis == 2 {
                let projected = projected_angles(&rot);
                assert_close(projected[axis], angle, 1e-14);
            }
            let vector = rotation_vector(&rot).to_array();
            for (k, component) in vector.iter().enumerate() {
                assert_close(*component, if k == axis { angle } else { 0.0 }, 1e-14);
            }
        }
    }
}

/// Truth: to second order a_P = a - bc/2, b_P = b + ac/2, c_P = c + ab/2 of the rotation vector;
/// at 1e-3 rad the third-order rest is below 1e-9.
#[test]
fn measures_differ_in_second_order() {
    let t = DVec3::new(1.0e-3, -0.8e-3, 0.6e-3);
    let rot = DMat3::from_axis_angle(t.normalize(), t.length());
    let p = projected_angles(&rot);
    assert_close(p[0], t.x - t.y * t.z / 2.0, 1e-9);
    assert_close(p[1], t.y + t.x * t.z / 2.0, 1e-9);
    assert_close(p[2], t.z + t.x * t.y / 2.0, 1e-9);
    assert!((p[0] - t.x).abs() > 1e-7, "the test must see the second order");
}

/// Twin: central differences with Richardson extrapolation; truncation (1e-3)^4 and rounding
/// 1e-16/1e-3 leave about 1e-11.
#[test]
fn derivatives_match_difference_quotients() {
    for formulation in [Formulation::Linear, Formulation::String] {
        for angles in [Angles::Projected, Angles::RotationVector] {
            for size in [0.0, 1e-5, 0.02, 0.4, 1.1] {
                let law = law(formulation, angles);
                let at = motion(size);
                let response = law.response(&at);
                assert_eq!(response.load, law.load(&at));
                for column in 0..12 {
                    let moved = |h: f64| law.load(&nudged(&at, column, h));
                    let quotient = |h: f64, row: usize| (moved(h)[row] - moved(-h)[row]) / (2.0 * h);
                    for row in 0..6 {
                        let h = 1e-3;
                        let expected = (4.0 * quotient(h / 2.0, row) - quotient(h, row)) / 3.0;
                        let actual = if column < 6 {
                            response.by_position[row][column]
                        } else {
                            response.by_velocity[row][column - 6]
                        };
                        assert_close(actual, expected, 3e-11);
                    }
                }
            }
        }
    }
}

/// The motion with one of twelve components moved: displacement, rotation in J axes, velocities.
fn nudged(at: &Relative, column: usize, h: f64) -> Relative {
    let mut to = *at;
    let axis = DVec3::from_array(std::array::from_fn(|k| f64::from(u8::from(k == column % 3))));
    match column / 3 {
        0 => to.d_ji_j += axis * h,
        1 => to.rot_ji = DMat3::from_axis_angle(axis, h) * at.rot_ji,
        2 => to.v_ji_j += axis * h,
        _ => to.w_ji_j += axis * h,
    }
    to
}

/// Truth: the string force is EA (l - L)/L along the line from I to J.
#[test]
fn a_string_pulls_along_its_chord() {
    let law = law(Formulation::String, Angles::Projected);
    let s = section();
    let r = DVec3::new(1.5, 2.0, 0.0); // 2.5 long
    let k = stiffness(&s);
    let at = Relative { d_ji_j: r, rot_ji: DMat3::IDENTITY, v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO };
    let load = law.load(&at);
    let pull = s.e * s.area * 0.5 / 2.0;
    assert_close(load[0], -pull * 0.6, 1e-15);
    assert_close(load[1], -pull * 0.8 - k[1][1] * 2.0, 1e-15);
}

/// Truth: the order of the 21 terms is the lower triangle by columns.
#[test]
fn damping_terms_are_placed_by_columns() {
    let terms: [f64; 21] = std::array::from_fn(|n| n as f64 + 1.0);
    let c = from_lower_triangle(&terms);
    assert_eq!((c[5][0], c[1][1], c[5][1], c[2][2], c[5][2]), (6.0, 7.0, 11.0, 12.0, 15.0));
    assert_eq!((c[3][3], c[5][3], c[4][4], c[5][4], c[5][5]), (16.0, 18.0, 19.0, 20.0, 21.0));
    assert_eq!(c[2][4], c[4][2]);
}
