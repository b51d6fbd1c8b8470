//! Tangents of LINEAR and STRING beams against complex steps, with both angle measures, with and without
//! shear and damping. (NONLINEAR has its own in `corotational.rs`.) The load is written again here, in
//! complex numbers and from the definitions: a twin for its value, and a derivative without subtraction.

use equations::Relative;
use glam::{DMat3, DVec3};
use num_complex::Complex64 as C;

use super::physics::{Angles, Formulation, Law, Mat6, Section, from_lower_triangle, proportional_damping, stiffness};

/// A step so small that its square vanishes beside any rounding.
const STEP: f64 = 1e-30;

fn section(shear: bool) -> Section {
    let (asy, asz) = if shear { (1.2, 1.7) } else { (0.0, 0.0) };
    Section { length: 2.0, area: 1.5, ixx: 4.0, iyy: 2.0, izz: 3.0, e: 0.4, g: 0.2, asy, asz }
}

fn motion(size: f64) -> Relative {
    Relative {
        d_ji_j: DVec3::new(2.1, 0.5, -0.4),
        rot_ji: DMat3::from_axis_angle(DVec3::new(0.5, -0.7, 0.4).normalize(), size),
        v_ji_j: DVec3::new(0.3, -0.2, 0.7),
        w_ji_j: DVec3::new(-0.4, 0.6, 0.1),
    }
}

/// The angle of a point of the plane, and what an imaginary step adds to it.
fn atan2(y: C, x: C) -> C {
    let square = x.re * x.re + y.re * y.re;
    C::new(y.re.atan2(x.re), (x.re * y.im - y.re * x.im) / square)
}

/// Relative angles from the axes of I in J, `axes[k]` being the k-th axis.
fn angles(how: Angles, axes: &[[C; 3]; 3]) -> [C; 3] {
    let [x, y, z] = axes;
    match how {
        // a = atan2(-A23, A33), b = atan2(A13, A33), c = atan2(A21, A11).
        Angles::Projected => [atan2(-z[1], z[2]), atan2(z[0], z[2]), atan2(x[1], x[0])],
        // The axis is in the skew part, whose length is the sine; the trace has the cosine.
        Angles::RotationVector => {
            let w = [0.5 * (y[2] - z[1]), 0.5 * (z[0] - x[2]), 0.5 * (x[1] - y[0])];
            let square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
            let factor = if square.re < 1e-6 {
                // asin(s)/s; the next term is below 1e-19.
                C::new(1.0, 0.0) + square / 6.0 + square * square * 0.075
            } else {
                let sine = square.sqrt();
                atan2(sine, 0.5 * (x[0] + y[1] + z[2] - 1.0)) / sine
            };
            w.map(|component| component * factor)
        }
    }
}

/// The load of the definitions: -K q - C qdot; STRING with its tension along the chord.
fn load(law: &Law, s: &Section, d: [C; 3], axes: &[[C; 3]; 3], rates: [C; 6]) -> [C; 6] {
    let angles = angles(law.angles, axes);
    let q = [d[0] - s.length, d[1], d[2], angles[0], angles[1], angles[2]];
    let along = |matrix: &Mat6, row: usize, x: &[C; 6]| -> C { (0..6).map(|k| x[k] * matrix[row][k]).sum() };
    let mut load: [C; 6] =
        std::array::from_fn(|row| -along(&law.stiffness, row, &q) - along(&law.damping, row, &rates));
    if law.formulation == Formulation::String {
        let chord = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let tension = (chord - s.length) * (s.e * s.area / s.length);
        load[0] += q[0] * law.stiffness[0][0];
        for k in 0..3 {
            load[k] -= tension * d[k] / chord;
        }
    }
    load
}

/// Both parts of the test for one law at one motion: values to rounding, derivatives to 1e-10.
fn compare(law: &Law, s: &Section, at: &Relative, what: &str) {
    let response = law.response(at);
    let stepped = |column: Option<usize>| {
        let step = |kind: usize| {
            let k = column.filter(|c| c / 3 == kind).map(|c| c % 3);
            DVec3::from_array(std::array::from_fn(|i| if Some(i) == k { STEP } else { 0.0 }))
        };
        let complex = |re: DVec3, im: DVec3| -> [C; 3] { std::array::from_fn(|k| C::new(re[k], im[k])) };
        let d = complex(at.d_ji_j, step(0));
        // A small rotation of I in the axes of J.
        let axes =
            [at.rot_ji.x_axis, at.rot_ji.y_axis, at.rot_ji.z_axis].map(|axis| complex(axis, step(1).cross(axis)));
        let (v, w) = (complex(at.v_ji_j, step(2)), complex(at.w_ji_j, step(3)));
        load(law, s, d, &axes, [v[0], v[1], v[2], w[0], w[1], w[2]])
    };
    for (row, value) in stepped(None).iter().enumerate() {
        assert!((response.load[row] - value.re).abs() < 1e-13, "{what} {row}: {} {value}", response.load[row]);
    }
    for column in 0..12 {
        for (row, value) in stepped(Some(column)).iter().enumerate() {
            let expected = value.im / STEP;
            let found =
                if column < 6 { response.by_position[row][column] } else { response.by_velocity[row][column - 6] };
            assert!((found - expected).abs() < 1e-10, "{what} {row} {column}: {found} {expected}");
        }
    }
}

#[test]
fn tangents_of_linear_and_string_are_those_of_complex_steps() {
    let terms: [f64; 21] = std::array::from_fn(|n| 0.1 + 0.03 * n as f64);
    for shear in [false, true] {
        let s = section(shear);
        let k = stiffness(&s);
        for (damped, damping) in
            [("none", [[0.0; 6]; 6]), ("ratio", proportional_damping(&k, 0.3)), ("matrix", from_lower_triangle(&terms))]
        {
            for formulation in [Formulation::Linear, Formulation::String] {
                for how in [Angles::Projected, Angles::RotationVector] {
                    for size in [0.0, 1e-6, 1e-3, 0.02, 0.4, 1.1, 1.5] {
                        let law = Law { length: s.length, stiffness: k, damping, formulation, angles: how };
                        let what = format!("{formulation:?} {how:?} {damped} {shear} {size}");
                        compare(&law, &s, &motion(size), &what);
                    }
                }
            }
        }
    }
}
