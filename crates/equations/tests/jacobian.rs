//! Derivatives of the whole system against differences, at random states that satisfy nothing.

extern crate flexure_equations as equations;

mod common;

use common::{Coupling, FLOOR, Random, assert_all_close, body, dense, frame, slope};
use equations::constraints::{Drive, Driven, Pair};
use equations::{Axis, BodyId, Constraint, FrameId, GROUND, System};
use glam::DVec3;
use solver::{Dae, JacobianPoint};

/// Three rigid bodies and a point mass; frame `2 b` and `2 b + 1` on body `b`, two on ground.
fn scene(random: &mut Random) -> System {
    let bodies: Vec<_> = [".m.a", ".m.b", ".m.c"].iter().map(|name| body(name, random, false)).collect();
    let bodies = [bodies, vec![body(".m.point", random, true)]].concat();
    let owners = (0..8).map(|at| BodyId(at / 2)).chain([GROUND, GROUND]);
    let frames: Vec<_> = owners.enumerate().map(|(at, owner)| frame(&format!(".m.f{at}"), owner, random)).collect();
    let f = FrameId;
    let name = |name: &str| format!(".m.{name}");
    let wave = |a: f64| Box::new(move |t: f64| [a * t.sin(), a * t.cos(), -a * t.sin()]);
    let joints: Vec<Box<dyn Constraint>> = vec![
        Box::new(Pair::fixed(name("fixed"), &frames, f(0), f(2))),
        Box::new(Pair::revolute(name("revolute"), &frames, f(1), f(8))),
        Box::new(Pair::translational(name("translational"), &frames, f(9), f(3))),
        Box::new(Pair::universal(name("universal"), &frames, f(4), f(1))),
        Box::new(Pair::hooke(name("hooke"), &frames, f(2), f(5))),
        Box::new(Pair::spherical(name("ball"), &frames, f(7), f(4))),
        Box::new(Pair::inplane(name("plane"), &frames, f(6), f(0))),
        Box::new(Driven::new(name("spin"), &frames, f(0), f(3), Drive::Rotation, wave(0.4))),
        Box::new(Driven::new(name("slide"), &frames, f(1), f(6), Drive::Translation(Axis::Y), wave(0.2))),
        Box::new(Driven::new(name("b1"), &frames, f(4), f(2), Drive::B1, wave(0.4))),
        Box::new(Driven::new(name("b2"), &frames, f(5), f(1), Drive::B2, wave(0.4))),
        Box::new(Driven::new(name("b3"), &frames, f(3), f(8), Drive::B3, wave(0.4))),
    ];
    let mut couple = |i: u32, j: u32, with_reaction: bool| -> Box<dyn equations::Force> {
        Box::new(Coupling { with_reaction, ..Coupling::new(&frames, f(i), f(j), random) })
    };
    let forces =
        vec![couple(0, 5, true), couple(3, 8, true), couple(9, 2, true), couple(6, 1, true), couple(4, 0, false)];
    System::new(bodies, frames, forces, joints, DVec3::new(0.3, -9.80665, 1.0)).unwrap()
}

/// Residual and constraint residual at an increment from `q`, as the solver sees them.
fn everything(
    system: &mut System,
    at: &JacobianPoint<'_>,
    q: &[f64],
    v: &[f64],
    a: &[f64],
    lambda: &[f64],
) -> Vec<f64> {
    let mut r = vec![0.0; system.velocities()];
    let mut phi = vec![0.0; system.constraints()];
    system.residual(at.t, q, v, a, lambda, &mut r).unwrap();
    system.constraint_residual(at.t, q, &mut phi).unwrap();
    r.extend(phi);
    r
}

/// Twin: sixth-order differences of the residual. Fails if any term of the Jacobian is missing.
#[test]
fn newton_matrix_is_the_derivative_of_the_residual() {
    for seed in 1..=3 {
        let mut random = Random(seed);
        let mut system = scene(&mut random);
        system.set_active(0, 2, false);
        system.set_active(5, 0, false);
        system.set_load_factor(0.8);
        let (q, v) = system.initial_state();
        let (nv, nl) = (system.velocities(), system.constraints());
        let (a, lambda) = (random.numbers(nv), random.numbers(nl));
        let factors = [(0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)];
        for (mass, damping, stiffness) in factors {
            let point = JacobianPoint { t: 0.3, q: &q, v: &v, a: &a, lambda: &lambda, mass, damping, stiffness };
            let matrix = dense(&mut system, point);
            for column in 0..nv {
                let wanted = slope(|h| {
                    let mut increment = vec![0.0; nv];
                    increment[column] = h;
                    let shift = |x: &[f64], factor: f64| -> Vec<f64> {
                        x.iter().zip(&increment).map(|(x, d)| x + factor * d).collect()
                    };
                    let mut moved = q.clone();
                    let turned: Vec<f64> = increment.iter().map(|d| d * stiffness).collect();
                    system.retract(&q, &turned, &mut moved);
                    everything(&mut system, &point, &moved, &shift(&v, damping), &shift(&a, mass), &lambda)
                });
                let got: Vec<f64> = (0..nv).map(|row| matrix[row][column]).collect();
                let what = format!("seed {seed}, {mass} {damping} {stiffness}, column {}", system.describe(column));
                assert_all_close(&got, &wanted[..nv], FLOOR, &what);
                if stiffness == 1.0 {
                    let rows: Vec<f64> = (0..nl).map(|row| matrix[nv + row][column]).collect();
                    assert_all_close(&rows, &wanted[nv..], FLOOR, &format!("constraints, {what}"));
                }
                for row in 0..nl {
                    assert_eq!(matrix[nv + row][column], matrix[column][nv + row], "B and its transpose differ");
                }
            }
        }
    }
}

/// Twin: differences along a motion with known velocity and acceleration.
#[test]
fn constraint_rates_follow_the_motion() {
    let mut random = Random(7);
    let mut system = scene(&mut random);
    let (q, v) = system.initial_state();
    let (nv, nl, t) = (system.velocities(), system.constraints(), 0.3);
    let a = random.numbers(nv);
    // Along q o exp(h v + h^2 a / 2) the body velocity is v + h a to second order, so the second
    // derivative of Phi at 0 is B a + gamma exactly.
    let mut along = |h: f64| {
        let increment: Vec<f64> = v.iter().zip(&a).map(|(v, a)| h * v + 0.5 * h * h * a).collect();
        let (mut moved, mut phi) = (q.clone(), vec![0.0; nl]);
        system.retract(&q, &increment, &mut moved);
        system.constraint_residual(t + h, &moved, &mut phi).unwrap();
        phi
    };
    let first = slope(&mut along);
    // Second derivative as the slope of the slope would lose digits; the sixth-order formula:
    let h = 1e-2;
    let weights = [(0.0, -490.0 / 180.0), (1.0, 1.5), (2.0, -0.15), (3.0, 2.0 / 180.0)];
    let mut second = vec![0.0; nl];
    for (steps, weight) in weights {
        for side in [1.0, -1.0] {
            let share = if steps == 0.0 { 0.5 } else { 1.0 };
            for (sum, phi) in second.iter_mut().zip(along(side * steps * h)) {
                *sum += share * weight * phi / (h * h);
            }
        }
    }
    let zero = vec![0.0; nl];
    let point = JacobianPoint { t, q: &q, v: &v, a: &a, lambda: &zero, mass: 0.0, damping: 0.0, stiffness: 0.0 };
    let matrix = dense(&mut system, point);
    let times = |x: &[f64]| -> Vec<f64> {
        (0..nl).map(|row| matrix[nv + row][..nv].iter().zip(x).map(|(b, x)| b * x).sum()).collect()
    };
    let (mut phi_t, mut gamma) = (zero.clone(), zero.clone());
    system.constraint_velocity(t, &q, &mut phi_t).unwrap();
    system.constraint_acceleration(t, &q, &v, &mut gamma).unwrap();
    let plus = |x: Vec<f64>, y: &[f64]| -> Vec<f64> { x.iter().zip(y).map(|(x, y)| x + y).collect() };
    assert_all_close(&plus(times(&v), &phi_t), &first, FLOOR, "velocity");
    // Rounding 1e-16 / h^2 = 1e-12, truncation h^6 = 1e-12 of the eighth derivative (up to 1e4).
    assert_all_close(&plus(times(&a), &gamma), &second, 3e-7, "acceleration");
}

/// `difference` inverts `retract`, also for angles near a half turn and tiny ones.
#[test]
fn difference_inverts_retraction() {
    let mut random = Random(11);
    let system = scene(&mut random);
    let (q, _) = system.initial_state();
    for scale in [1e-12, 1e-6, 1e-3, 1.0, 1.7] {
        let increment: Vec<f64> = random.numbers(system.velocities()).iter().map(|x| scale * x).collect();
        let (mut moved, mut back) = (q.clone(), increment.clone());
        system.retract(&q, &increment, &mut moved);
        system.difference(&q, &moved, &mut back);
        for (got, wanted) in back.iter().zip(&increment) {
            // Quaternion entries of order one carry 1e-16 each.
            assert!((got - wanted).abs() < 2e-15, "{got} is not {wanted}");
        }
    }
}

#[test]
fn unknowns_are_named() {
    let mut random = Random(1);
    let mut system = scene(&mut random);
    assert_eq!(system.describe(0), ".m.a translation x");
    assert_eq!(system.describe(11), ".m.b rotation about z");
    assert_eq!(system.describe(20), ".m.point translation z");
    assert_eq!(system.describe(21), ".m.fixed X");
    assert_eq!(system.describe(21 + 6 + 3), ".m.revolute Zi.Xj");
    system.set_active(0, 0, false);
    assert_eq!(system.describe(21), ".m.fixed Y");
    assert_eq!(system.constraint_rows(0.0, &system.initial_state().0).unwrap().len(), system.constraints() + 1);
}
