//! The NONLINEAR beam against its potential, complex numbers, symmetries and closed forms.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::{DMat3, DVec3};

use super::*;
use crate::forces::beam::physics::stiffness;

/// Numbers for complex steps: a derivative without subtraction, hence exact to rounding.
#[derive(Clone, Copy, Debug)]
struct Complex(num_complex::Complex64);

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Complex {
            type Output = Complex;
            fn $method(self, other: Complex) -> Complex {
                Complex(self.0.$method(other.0))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Complex {
    type Output = Complex;
    fn neg(self) -> Complex {
        Complex(-self.0)
    }
}
impl Mul<f64> for Complex {
    type Output = Complex;
    fn mul(self, factor: f64) -> Complex {
        Complex(self.0 * factor)
    }
}
impl Add<f64> for Complex {
    type Output = Complex;
    fn add(self, constant: f64) -> Complex {
        Complex(self.0 + constant)
    }
}
impl Scalar for Complex {
    fn constant(value: f64) -> Complex {
        Complex(value.into())
    }
    fn value(self) -> f64 {
        self.0.re
    }
    fn sqrt(self) -> Complex {
        Complex(self.0.sqrt())
    }
    fn tan(self) -> Complex {
        Complex(self.0.tan())
    }
    /// The real angle, and what an imaginary step adds to it: of first order, which is all that a
    /// step of 1e-30 can show. (The logarithm would lose it in the rounding of the real part.)
    fn atan2(self, x: Complex) -> Complex {
        let (y, x) = (self.0, x.0);
        Complex(num_complex::Complex64::new(
            y.re.atan2(x.re),
            (x.re * y.im - y.re * x.im) / (x.re * x.re + y.re * y.re),
        ))
    }
}

fn section() -> Section {
    Section { length: 2.0, area: 1.5, ixx: 4.0, iyy: 2.0, izz: 3.0, e: 0.4, g: 0.2, asy: 0.9, asz: 0.8 }
}

fn beam(with_shear: bool) -> Corotational {
    Corotational::new(&section(), with_shear, 0.3)
}

fn at_rest(beam: Corotational) -> Corotational {
    Corotational { damping_ratio: 0.0, ..beam }
}

/// A motion with a relative rotation of the given size.
fn motion(size: f64) -> Relative {
    Relative {
        d_ji_j: DVec3::new(2.1, 0.5, -0.4),
        rot_ji: DMat3::from_axis_angle(DVec3::new(0.5, -0.7, 0.4).normalize(), size),
        v_ji_j: DVec3::new(0.3, -0.2, 0.7),
        w_ji_j: DVec3::new(-0.4, 0.6, 0.1),
    }
}

/// The place of I moved by an imaginary step along one of the six coordinates.
fn stepped(at: &Relative, column: usize, h: f64) -> (V3<Complex>, M3<Complex>) {
    let complex = |re: f64, im: f64| Complex(num_complex::Complex64::new(re, im));
    let along = DVec3::from_array(std::array::from_fn(|k| f64::from(u8::from(k == column % 3))));
    let (dd, dp) = if column < 3 { (along * h, DVec3::ZERO) } else { (DVec3::ZERO, along * h) };
    let d = std::array::from_fn(|k| complex(at.d_ji_j[k], dd[k]));
    let turned = |axis: DVec3| {
        let by = dp.cross(axis);
        std::array::from_fn(|k| complex(axis[k], by[k]))
    };
    (d, [at.rot_ji.x_axis, at.rot_ji.y_axis, at.rot_ji.z_axis].map(turned))
}

/// Twin: minus the gradient of the potential by complex steps of 1e-30, which is exact to rounding.
#[test]
fn the_load_is_minus_the_gradient_of_the_energy() {
    for with_shear in [false, true] {
        for size in [0.0, 1e-6, 0.02, 0.3, 0.9, 1.4] {
            let (law, at) = (at_rest(beam(with_shear)), motion(size));
            let load = law.load(&at);
            let largest = load.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            for (row, value) in load.iter().enumerate() {
                let (d, axes) = stepped(&at, row, 1e-30);
                let gradient = law.energy_of(d, axes).0.im / 1e-30;
                assert!((value + gradient).abs() < 1e-14 * largest.max(1.0), "{size} {row}: {value} {gradient}");
            }
        }
    }
}

/// Twin: complex steps of the load, damping included, to 1e-10 as every law of a beam must; and the
/// damping itself, which is linear in the velocities.
#[test]
fn the_derivative_is_that_of_complex_steps() {
    for size in [0.0, 1e-6, 0.02, 0.3, 0.9, 1.4] {
        let (law, at) = (beam(size > 0.1), motion(size));
        let (load, by_position, by_velocity) = law.response(&at);
        assert_eq!(load, law.load(&at));
        for column in 0..6 {
            let (d, axes) = stepped(&at, column, 1e-30);
            let moved = law.load_of(d, axes, &at);
            for row in 0..6 {
                let expected = moved[row].0.im / 1e-30;
                assert!((by_position[row][column] - expected).abs() < 1e-12, "{size} {row} {column}");
            }
            let mut faster = at;
            let step = DVec3::from_array(std::array::from_fn(|k| f64::from(u8::from(k == column % 3))));
            if column < 3 {
                faster.v_ji_j += step;
            } else {
                faster.w_ji_j += step;
            }
            for (row, value) in law.load(&faster).iter().enumerate() {
                assert!((value - load[row] - by_velocity[row][column]).abs() < 1e-13, "{size} {row} {column}");
            }
        }
    }
}

/// Truth: undeformed, the derivative is the linear beam's stiffness, with shear the Timoshenko one.
#[test]
fn small_deformations_meet_the_linear_stiffness() {
    for with_shear in [false, true] {
        let s = if with_shear { section() } else { Section { asy: 0.0, asz: 0.0, ..section() } };
        let k = stiffness(&s);
        let rest = Relative { d_ji_j: DVec3::X * s.length, rot_ji: DMat3::IDENTITY, ..motion(0.0) };
        let (load, by_position, by_velocity) = at_rest(beam(with_shear)).response(&rest);
        assert!(load.iter().all(|x| x.abs() < 1e-16));
        let damped = beam(with_shear).response(&rest).2;
        for row in 0..6 {
            for column in 0..6 {
                assert!((by_position[row][column] + k[row][column]).abs() < 1e-15, "{row} {column}");
                assert_eq!(by_velocity[row][column], 0.0);
                assert!((damped[row][column] + 0.3 * k[row][column]).abs() < 1e-15, "{row} {column}");
            }
        }
    }
}

/// Truth: the law does not know which end is I: exchanging the markers, both turned half a turn about
/// z so that the axes point along the beam again, gives the same loads on the same parts.
#[test]
fn either_end_may_be_called_i() {
    let half = DMat3::from_diagonal(DVec3::new(-1.0, -1.0, 1.0));
    for size in [0.1, 0.7, 1.2] {
        let (law, at) = (beam(true), motion(size));
        let load = law.load(&at);
        let (f, t) = (DVec3::from_slice(&load[..3]), DVec3::from_slice(&load[3..]));
        // On J, in J axes: what the reaction rule makes of it.
        let (f_j, t_j) = (-f, -t - at.d_ji_j.cross(f));
        // The old J as seen from the old I, whose frames are turned by `half`.
        let to_i = at.rot_ji.transpose();
        let seen = |vector: DVec3| half * (to_i * vector);
        let swapped = Relative {
            d_ji_j: seen(-at.d_ji_j),
            rot_ji: half * to_i * half,
            v_ji_j: seen(-at.v_ji_j + at.w_ji_j.cross(at.d_ji_j)),
            w_ji_j: seen(-at.w_ji_j),
        };
        let again = law.load(&swapped);
        let (f_again, t_again) = (DVec3::from_slice(&again[..3]), DVec3::from_slice(&again[3..]));
        assert!((f_again - seen(f_j)).length() < 1e-14, "{size}: {f_again} {}", seen(f_j));
        assert!((t_again - seen(t_j)).length() < 1e-14, "{size}: {t_again} {}", seen(t_j));
    }
}

/// Truth: damping takes power wherever I moves relative to J, and none from a rotation of the whole.
#[test]
fn damping_takes_power() {
    let law = beam(false);
    for size in [0.0, 0.5, 1.3] {
        let at = motion(size);
        let still = Relative { v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO, ..at };
        let (moving, elastic) = (law.load(&at), law.load(&still));
        let rate = [at.v_ji_j.to_array(), at.w_ji_j.to_array()].concat();
        let power: f64 = (0..6).map(|k| (elastic[k] - moving[k]) * rate[k]).sum();
        assert!(power > 0.0);
        assert!((power - law.dissipation(&at)).abs() < 1e-14 * power.max(1.0));
        assert_eq!(law.dissipation(&still), 0.0);
    }
}

/// Truth: a beam bent to an arc of the angle `a` by end moments keeps its length along the arc. The
/// shallow arch gives the moment EI a / L, the strain of section B.11 vanishes to fourth order.
#[test]
fn an_arc_takes_the_moment_of_its_curvature() {
    let s = Section { asy: 0.0, asz: 0.0, ..section() };
    let law = at_rest(beam(false));
    let angle = 0.1_f64;
    let radius = s.length / angle;
    let at = Relative {
        d_ji_j: DVec3::new(radius * angle.sin(), radius * (1.0 - angle.cos()), 0.0),
        rot_ji: DMat3::from_rotation_z(angle),
        v_ji_j: DVec3::ZERO,
        w_ji_j: DVec3::ZERO,
    };
    let load = law.load(&at);
    let moment = s.e * s.izz * angle / s.length;
    // The chord is shorter by a^2/24 - a^4/1920; a^2/24 is in the strain, the rest is a^4/1920.
    let axial = s.e * s.area * angle.powi(4) / 1920.0;
    assert!((load[5] + moment).abs() < 1e-4 * moment, "{} {moment}", load[5]);
    assert!(load[0].hypot(load[1]) < 1.1 * axial && load[2].abs() + load[3].abs() + load[4].abs() < 1e-16);
}
