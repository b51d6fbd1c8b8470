//! What goes through a beam, what it stores and what it takes: closed forms, balance, power.

use glam::{DMat3, DVec3};

use super::*;
use crate::forces::beam::{
    corotational::Corotational,
    physics::{Angles, Mat6, Section, from_lower_triangle, proportional_damping, stiffness},
};
use crate::forces::elastic::{Law as _, inside};

const RATIO: f64 = 0.3;

/// A strip: all six stiffnesses differ.
fn section() -> Section {
    Section { length: 2.0, area: 1.5, ixx: 0.4, iyy: 0.2, izz: 0.3, e: 40.0, g: 20.0, asy: 0.9, asz: 0.8 }
}

/// A symmetric positive definite matrix with all terms.
fn damping_terms() -> Mat6 {
    let mut terms = [0.0; 21];
    for (n, term) in terms.iter_mut().enumerate() {
        *term = 0.01 * (1.0 + n as f64) + if [0, 6, 11, 15, 18, 20].contains(&n) { 1.0 } else { 0.0 };
    }
    from_lower_triangle(&terms)
}

/// Every formulation (NONLINEAR with shear, so that one closed form is that of all), damped by a ratio or
/// by a matrix.
fn laws() -> Vec<(&'static str, Law)> {
    let s = section();
    let k = stiffness(&s);
    let mut all = Vec::new();
    for matrix in [false, true] {
        let ratio = if matrix { 0.0 } else { RATIO };
        let nonlinear = Formulation::Nonlinear(Corotational::new(&s, true, ratio));
        for (name, formulation) in
            [("linear", Formulation::Linear), ("string", Formulation::String), ("nonlinear", nonlinear)]
        {
            let damping = match (matrix, name) {
                (true, _) => damping_terms(),
                (false, "nonlinear") => [[0.0; 6]; 6],
                (false, _) => proportional_damping(&k, RATIO),
            };
            let angles = Angles::Projected;
            all.push((name, Law { length: s.length, stiffness: k, damping, formulation, angles }));
        }
    }
    all
}

fn at(d: DVec3, turn: DVec3) -> Relative {
    let rot_ji =
        if turn == DVec3::ZERO { DMat3::IDENTITY } else { DMat3::from_axis_angle(turn.normalize(), turn.length()) };
    Relative { d_ji_j: d, rot_ji, v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO }
}

/// A state of large rotations in space, moving.
fn wild() -> Relative {
    Relative {
        v_ji_j: DVec3::new(0.3, -0.2, 0.7),
        w_ji_j: DVec3::new(-0.4, 0.6, 0.1),
        ..at(DVec3::new(1.9, 0.5, -0.4), DVec3::new(0.3, -0.4, 0.5))
    }
}

fn close(what: &str, actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual} is not {expected} within {tolerance:e}");
}

/// Deflection and rotation of a Timoshenko cantilever under a force and a moment at its tip.
struct Tip {
    force: DVec3,
    moment: DVec3,
}

impl Tip {
    fn deflected(&self) -> Relative {
        let (s, f, m) = (section(), self.force, self.moment);
        let l = s.length;
        let across = |p: f64, ei: f64, shear: f64, m: f64| {
            (
                p * l.powi(3) / (3.0 * ei) + shear * p * l / (s.g * s.area) + m * l * l / (2.0 * ei),
                p * l * l / (2.0 * ei) + m * l / ei,
            )
        };
        // Along z a positive slope is a rotation about -y.
        let (y, c) = across(f.y, s.e * s.izz, s.asy, m.z);
        let (z, b) = across(f.z, s.e * s.iyy, s.asz, -m.y);
        let x = f.x * l / (s.e * s.area);
        at(DVec3::new(l + x, y, z), DVec3::new(m.x * l / (s.g * s.ixx), -b, c))
    }

    /// Clapeyron: half of what a load that is applied slowly does on its way.
    fn energy(&self) -> f64 {
        let (s, f, m) = (section(), self.force, self.moment);
        let l = s.length;
        let across = |p: f64, ei: f64, shear: f64, m: f64| {
            p * p * l.powi(3) / (6.0 * ei)
                + shear * p * p * l / (2.0 * s.g * s.area)
                + m * m * l / (2.0 * ei)
                + p * m * l * l / (2.0 * ei)
        };
        f.x * f.x * l / (2.0 * s.e * s.area)
            + m.x * m.x * l / (2.0 * s.g * s.ixx)
            + across(f.y, s.e * s.izz, s.asy, m.z)
            + across(f.z, s.e * s.iyy, s.asz, -m.y)
    }
}

/// One load at a time, of size 1e-6.
fn tips() -> Vec<Tip> {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * 1e-6);
    let force = axes.map(|force| Tip { force, moment: DVec3::ZERO });
    let moment = axes.map(|moment| Tip { force: DVec3::ZERO, moment });
    force.into_iter().chain(moment).collect()
}

/// Truth: cut off, the piece from x to the tip is in balance: N, Vy and Vz are the tip's force, and the
/// moment at x is the tip's and `(L - x) e_x` x force: MY = M - P_z (L - x), MZ = M + P_y (L - x).
/// Deflections of 1e-6 turn the section by as much: one part in 1e5 of the largest.
#[test]
fn a_cantilever_carries_its_tip_load_to_the_root() {
    let l = section().length;
    for (name, law) in laws() {
        for tip in tips() {
            let found = inside(&law, &tip.deflected());
            let tolerance = 1e-5 * 1e-6 * l;
            for station in [0.0, 0.25, 0.5, 1.0] {
                let arm = DVec3::X * (l * (1.0 - station));
                let (moment, wanted) = (found.moment(station), tip.moment + arm.cross(tip.force));
                assert!((moment - wanted).length() < tolerance, "{name} at {station}: {moment} is not {wanted}");
            }
            assert!((found.force - tip.force).length() < tolerance, "{name}: {}", found.force);
        }
    }
}

/// Truth: a linear beam's cut moment is `P (L - x)` to rounding of numbers of 1e-2: I stays at x = L, and
/// in a plane its angle is the projected one.
#[test]
fn a_linear_cantilever_does_so_to_rounding() {
    let (_, law) = laws().remove(0);
    let l = section().length;
    for force in [DVec3::Y, DVec3::Z] {
        let tip = Tip { force: force * 1e-3, moment: DVec3::ZERO };
        let found = inside(&law, &tip.deflected());
        for station in [0.0, 0.5, 1.0] {
            let wanted = (DVec3::X * (l * (1.0 - station))).cross(tip.force);
            assert!((found.moment(station) - wanted).length() < 1e-17, "{} {wanted}", found.moment(station));
        }
        assert!((found.force - tip.force).length() < 1e-17, "{}", found.force);
    }
}

/// Truth: what goes through at the ends is the load on J, and minus the load on I; in between shear is
/// the slope of the moment, `dM/ds = -d x V`. Rounding, in any state and motion.
#[test]
fn both_ends_balance_the_loads_on_the_markers() {
    for (name, law) in laws() {
        let motion = wild();
        let found = inside(&law, &motion);
        let load = law.load(&motion);
        let (force, torque) = (DVec3::from_slice(&load[..3]), DVec3::from_slice(&load[3..]));
        let axes = law.section_axes(&motion);
        let size = force.length().max(torque.length());
        let off = |what: &str, a: DVec3, b: DVec3| {
            assert!((a - b).length() < 1e-13 * size, "{name} {what}: {a} is not {b}");
        };
        let on_j = -torque - motion.d_ji_j.cross(force);
        off("force on J", axes * found.force, -force);
        off("moment on J", axes * found.moment_j, on_j);
        off("moment on I", axes * found.moment_i, -torque);
        let d = axes.transpose() * motion.d_ji_j;
        off("slope", found.moment_i - found.moment_j, -d.cross(found.force));
        off("axes", axes.x_axis.cross(axes.y_axis) * size, axes.z_axis * size);
        if name == "nonlinear" {
            // Along the chord: dMY/dx = VZ, dMZ/dx = -VY, and the torque is the same everywhere.
            off("chord", d, DVec3::X * motion.d_ji_j.length());
            close("torque", found.moment_j.x, found.moment_i.x, 1e-13 * size);
        }
    }
}

/// Truth: Clapeyron; P^2 L^3/6EI and its like. Rotations of 1e-6 change an energy by one part in 1e5.
#[test]
fn strain_energy_is_the_work_of_a_slow_load() {
    for (name, law) in laws() {
        for tip in tips() {
            let (energy, work) = (law.energy(&tip.deflected()), tip.energy());
            close(name, energy, work, 1e-5 * work);
        }
        let both = Tip { force: DVec3::new(0.0, 1e-6, 2e-6), moment: DVec3::new(0.0, 3e-6, -1e-6) };
        close(name, law.energy(&both.deflected()), both.energy(), 1e-5 * both.energy());
    }
}

/// Work that the elastic load takes on a way of I, by Simpson's rule; spin about z of J is `turn.z`'s rate.
fn work(law: &Law, way: impl Fn(f64) -> (Relative, DVec3, DVec3)) -> f64 {
    let pieces = 200;
    let power = |k: usize| {
        let (motion, v, w) = way(k as f64 / f64::from(pieces));
        let load = law.load(&motion);
        -(DVec3::from_slice(&load[..3]).dot(v) + DVec3::from_slice(&load[3..]).dot(w))
    };
    let weight = |k: usize| if k == 0 || k == pieces as usize { 1.0 } else { 2.0 + 2.0 * f64::from(k as u32 % 2) };
    (0..=pieces as usize).map(|k| weight(k) * power(k)).sum::<f64>() / (3.0 * f64::from(pieces))
}

/// Truth: in a plane every formulation has a potential: the work on a way there is the energy, however
/// large the rotations. Simpson's rule with 200 pieces leaves (1/200)^4.
#[test]
fn in_a_plane_energy_is_the_work_on_any_way() {
    for (name, law) in laws() {
        let law = Law { damping: [[0.0; 6]; 6], ..law };
        let way = |t: f64| {
            let d = DVec3::new(2.0 - 0.3 * t * t, 0.9 * t, 0.0);
            let (v, w) = (DVec3::new(-0.6 * t, 0.9, 0.0), DVec3::new(0.0, 0.0, 0.8));
            (at(d, DVec3::Z * (0.8 * t)), v, w)
        };
        let (done, energy) = (work(&law, way), law.energy(&way(1.0).0));
        close(name, done, energy, 1e-8 * energy);
    }
}

/// In space only NONLINEAR has one; what the quadratic form of the others is off by is of third order in
/// the angles: an eighth for half of them.
#[test]
fn in_space_the_energy_of_linear_beams_is_off_by_third_order() {
    let error = |law: &Law, size: f64| {
        let axis = DVec3::new(0.5, -0.6, 0.7) * size;
        let way = |t: f64| {
            let d = DVec3::new(2.0, 0.5 * size * t, -0.4 * size * t);
            (at(d, axis * t), DVec3::new(0.0, 0.5 * size, -0.4 * size), axis)
        };
        (work(law, way) - law.energy(&way(1.0).0)).abs()
    };
    for (name, law) in laws() {
        let law = Law { damping: [[0.0; 6]; 6], ..law };
        if name == "nonlinear" {
            assert!(error(&law, 0.5) < 1e-8, "{name}: {}", error(&law, 0.5));
            continue;
        }
        let (large, small) = (error(&law, 0.2), error(&law, 0.1));
        assert!(large > 1e-6 && (large / small) > 7.0, "{name}: {large:e} and {small:e}");
    }
}

/// Twin: the power of that part of the load which vanishes at rest. It is taken from every motion.
#[test]
fn dissipation_is_the_power_of_the_damping_loads() {
    for (name, law) in laws() {
        let motion = wild();
        let still = Relative { v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO, ..motion };
        let (moving, resting) = (law.load(&motion), law.load(&still));
        let rate = [motion.v_ji_j.to_array(), motion.w_ji_j.to_array()].concat();
        let power: f64 = (0..6).map(|k| (resting[k] - moving[k]) * rate[k]).sum();
        let found = elastic::Law::dissipation(&law, &motion);
        assert!(found > 0.0, "{name}");
        close(name, found, power, 1e-12 * power);
        close(name, elastic::Law::dissipation(&law, &still), 0.0, 0.0);
    }
}

/// Truth: a bar that is pulled at 0.1 m/s takes `ratio EA/L v^2`, and so on for twisting and bending.
#[test]
fn proportional_damping_takes_the_ratio_times_stiffness_times_rate_squared() {
    let s = section();
    let rest = at(DVec3::X * s.length, DVec3::ZERO);
    for (name, law) in laws().into_iter().take(3) {
        let pulled = Relative { v_ji_j: DVec3::X * 0.1, ..rest };
        close(name, Law::dissipation(&law, &pulled), RATIO * s.e * s.area / s.length * 0.01, 1e-15);
        let twisted = Relative { w_ji_j: DVec3::X * 0.1, ..rest };
        close(name, Law::dissipation(&law, &twisted), RATIO * s.g * s.ixx / s.length * 0.01, 1e-15);
        // Bent into an arc: no shear, all of it in EI/L.
        let bent = Relative { v_ji_j: DVec3::Y * (0.05 * s.length), w_ji_j: DVec3::Z * 0.1, ..rest };
        close(name, Law::dissipation(&law, &bent), RATIO * s.e * s.izz / s.length * 0.01, 1e-14);
    }
}

/// Truth: the largest angle is that of the tip in J for LINEAR, and out of the chord for NONLINEAR, where an
/// arc of 0.4 rad leaves 0.2 at each end.
#[test]
fn the_angle_is_the_one_the_law_sees() {
    let radius = section().length / 0.4;
    let arc = at(DVec3::new(radius * 0.4_f64.sin(), radius * (1.0 - 0.4_f64.cos()), 0.0), DVec3::Z * 0.4);
    let angles: Vec<f64> = laws().iter().take(3).map(|(_, law)| inside(law, &arc).angle).collect();
    close("linear", angles[0], 0.4, 1e-15);
    close("string", angles[1], 0.4, 1e-15);
    close("nonlinear", angles[2], 0.2, 1e-15);
}
