//! Bodies without constraints: spinning freely, coupled by internal loads, falling.

extern crate flexure_equations as equations;

mod common;

use common::{Coupling, Random, assert_all_close, body, frame};
use equations::{BodyId, FrameId, System};
use glam::{DMat3, DVec3};
use solver::Dae;

fn alone(inertia: DVec3, w: DVec3) -> System {
    let mut random = Random(2);
    let mut top = body(".m.top", &mut random, false);
    top.inertia_c_b = DMat3::from_diagonal(inertia);
    top.initial.w_gb_b = w;
    System::new(vec![top], Vec::new(), Vec::new(), Vec::new(), DVec3::ZERO).unwrap()
}

/// Truth: Euler's symmetric top, w1 = A cos(n t), w2 = A sin(n t), n = (I3 - I1) w3 / I1.
#[test]
fn symmetric_top_precesses() {
    let (i1, i3, w3, amplitude, t) = (2.0, 0.5, 3.0, 0.7, 0.4_f64);
    let n = (i3 - i1) * w3 / i1;
    let w = DVec3::new(amplitude * (n * t).cos(), amplitude * (n * t).sin(), w3);
    let mut system = alone(DVec3::new(i1, i1, i3), w);
    let (q, v) = system.initial_state();
    let a = [0.0, 0.0, 0.0, -n * w.y, n * w.x, 0.0];
    let mut r = vec![1.0; 6];
    system.residual(0.0, &q, &v, &a, &[], &mut r).unwrap();
    assert_all_close(&r, &[0.0; 6], 1e-15, "residual of the exact motion");
}

/// Truth: a free body keeps energy and momentum. Runge-Kutta of fourth order in the chart of each
/// step, h = 2e-3: the error per unit of time is about h^4 = 2e-11.
#[test]
fn asymmetric_body_keeps_energy_and_momentum() {
    let mut system = alone(DVec3::new(1.0, 2.0, 2.7), DVec3::new(0.1, 3.0, 0.2));
    let (mut q, mut v) = system.initial_state();
    system.state(0.0, &q, &v, None);
    let (energy, (linear, angular)) = (system.kinetic_energy(), system.momentum());
    let inertia = [2.5, 2.5, 2.5, 1.0, 2.0, 2.7];
    // d(theta)/dt = w + theta x w / 2 + theta x (theta x w) / 12 near theta = 0
    let chart = |theta: &[f64], v: &[f64]| -> Vec<f64> {
        let (theta, w) = (DVec3::from_slice(&theta[3..]), DVec3::from_slice(&v[3..]));
        let turn = w + 0.5 * theta.cross(w) + theta.cross(theta.cross(w)) / 12.0;
        [&v[..3], &turn.to_array()].concat()
    };
    let h = 2e-3;
    for _ in 0..1500 {
        let start = (vec![0.0; 6], v.clone());
        let (mut sum_x, mut sum_v) = (vec![0.0; 6], vec![0.0; 6]);
        let mut stage = start.clone();
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            let (mut q_stage, mut r) = (q.clone(), vec![0.0; 6]);
            system.retract(&q, &stage.0, &mut q_stage);
            system.residual(0.0, &q_stage, &stage.1, &[0.0; 6], &[], &mut r).unwrap();
            let rate_x = chart(&stage.0, &stage.1);
            let rate_v: Vec<f64> = r.iter().zip(inertia).map(|(r, m)| -r / m).collect();
            for at in 0..6 {
                sum_x[at] += h * weight / 6.0 * rate_x[at];
                sum_v[at] += h * weight / 6.0 * rate_v[at];
                stage.0[at] = h * next * rate_x[at];
                stage.1[at] = start.1[at] + h * next * rate_v[at];
            }
        }
        let before = q.clone();
        system.retract(&before, &sum_x, &mut q);
        v.iter_mut().zip(&sum_v).for_each(|(v, change)| *v += change);
    }
    system.state(0.0, &q, &v, None);
    // Three units of time at rates up to 3 rad/s: 3 * 3^5 * h^4 / 120 is about 1e-10.
    let tolerance = 1e-9;
    let rate = |after: f64, before: f64| (after / before - 1.0).abs();
    assert!(rate(system.kinetic_energy(), energy) < tolerance);
    let (linear_after, angular_after) = system.momentum();
    assert_all_close(&linear_after.to_array(), &linear.to_array(), 1e-15, "linear momentum");
    // The position moves with the velocity, so r x m v stays; the spin part is integrated.
    assert_all_close(&angular_after.to_array(), &angular.to_array(), tolerance, "angular momentum");
    // It has tumbled: the middle axis is unstable, w_y changes sign.
    assert!(v[4] < 0.0, "{}", v[4]);
}

/// Truth: loads between bodies change neither linear nor angular momentum.
#[test]
fn internal_loads_have_no_resultant() {
    let mut random = Random(6);
    let bodies = vec![body(".m.a", &mut random, false), body(".m.b", &mut random, false)];
    let frames = vec![frame(".m.i", BodyId(0), &mut random), frame(".m.j", BodyId(1), &mut random)];
    let force = Coupling::new(&frames, FrameId(0), FrameId(1), &mut random);
    let mut system = System::new(bodies, frames, vec![Box::new(force)], Vec::new(), DVec3::ZERO).unwrap();
    let (q, v) = system.initial_state();
    let zero = [0.0; 12];
    let (mut r, mut inertia_only) = (zero.to_vec(), zero.to_vec());
    system.residual(0.0, &q, &v, &zero, &[], &mut r).unwrap();
    system.set_load_factor(0.0);
    system.residual(0.0, &q, &v, &zero, &[], &mut inertia_only).unwrap();
    let state = system.state(0.0, &q, &v, None);
    let (mut force, mut moment) = (DVec3::ZERO, DVec3::ZERO);
    for at in 0..2 {
        let load: Vec<f64> = (6 * at..6 * at + 6).map(|row| inertia_only[row] - r[row]).collect();
        let (f, t) = (DVec3::from_slice(&load[..3]), DVec3::from_slice(&load[3..]));
        assert!(f.length() > 0.1, "the test needs a load");
        force += f;
        moment += state.bodies[at].r_gb_g.cross(f) + state.rotations[at] * t;
    }
    assert!(force.length() < 1e-14 && moment.length() < 1e-13, "{force} {moment}");
}

/// Truth: gravity alone; the load factor scales it; statics forgets velocities.
#[test]
fn gravity_load_factor_and_statics() {
    let mut random = Random(8);
    let bodies = vec![body(".m.a", &mut random, false), body(".m.point", &mut random, true)];
    let g = DVec3::new(0.0, 0.0, -9.80665);
    let mut system = System::new(bodies, Vec::new(), Vec::new(), Vec::new(), g).unwrap();
    let (q, v) = system.initial_state();
    assert_eq!((q.len(), v.len()), (10, 9));
    system.set_statics(true);
    system.set_load_factor(0.5);
    let mut r = vec![1.0; 9];
    system.residual(0.0, &q, &v, &[0.0; 9], &[], &mut r).unwrap();
    let weight = 0.5 * 2.5 * 9.80665;
    assert_all_close(&r, &[0.0, 0.0, weight, 0.0, 0.0, 0.0, 0.0, 0.0, weight], 1e-15, "residual");
    assert_eq!(system.kinetic_energy(), 0.0);
    system.set_length_unit(1e-3);
    assert_eq!(system.units().increments, [1e-3, 1e-3, 1e-3, 1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-3]);
}
