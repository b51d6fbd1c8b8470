//! Whole motions with the solver's integrator: the two rooms together.

extern crate flexure_equations as equations;

mod common;

use std::f64::consts::TAU;

use common::Random;
use equations::constraints::{Drive, Driven, Pair};
use equations::{BodyId, Constraint, Frame, FrameId, GROUND, Side, System, measures};
use glam::{DMat3, DQuat, DVec3};
use solver::{Dae, IntegratorOptions, Method, Silent, SystemState, initial, integrate};

const G: f64 = 9.80665;

/// A bar of length 1 and mass 2.5 from (0, 0, 0) along -y, turned by `phi` about z at the origin.
fn bar(phi: f64, at: DVec3) -> equations::Body {
    let mut bar = common::body(".m.bar", &mut Random(1), false);
    bar.inertia_c_b = DMat3::from_diagonal(DVec3::new(2.5 / 12.0, 1e-3, 2.5 / 12.0));
    let q = DQuat::from_rotation_z(phi);
    bar.initial = common::motion(at + q * DVec3::new(0.0, -0.5, 0.0), q, DVec3::ZERO, DVec3::ZERO);
    bar
}

fn end(body: u32, y: f64) -> Frame {
    Frame { name: ".m.end".into(), body: BodyId(body), r_bi_b: DVec3::new(0.0, y, 0.0), rot_bi: DMat3::IDENTITY }
}

fn ground() -> Frame {
    Frame { name: ".m.base".into(), body: GROUND, r_bi_b: DVec3::ZERO, rot_bi: DMat3::IDENTITY }
}

fn run(system: &mut System, end: f64, error: f64) -> SystemState {
    let (q, v) = system.initial_state();
    let mut state = SystemState::at_rest(system, 0.0, q);
    state.v = v;
    initial::accelerations(system, &mut state).unwrap();
    let options =
        IntegratorOptions { method: Method::GeneralisedAlpha { rho: 0.8 }, error, ..IntegratorOptions::default() };
    integrate(system, &mut state, end, &[end], &options, &mut Silent).unwrap();
    state
}

/// Truth: without friction the energy of a double pendulum stays, and both hinges hold.
#[test]
fn double_pendulum_keeps_its_energy() {
    let tip = DQuat::from_rotation_z(1.2) * DVec3::new(0.0, -1.0, 0.0);
    let bodies = vec![bar(1.2, DVec3::ZERO), bar(2.0, tip)];
    let frames = vec![end(0, 0.5), ground(), end(1, 0.5), end(0, -0.5)];
    let joint = |i: u32, j: u32| -> Box<dyn Constraint> {
        Box::new(Pair::revolute(".m.joint".into(), &frames, FrameId(i), FrameId(j)))
    };
    let joints = vec![joint(0, 1), joint(2, 3)];
    let mut system = System::new(bodies, frames, Vec::new(), joints, DVec3::new(0.0, -G, 0.0)).unwrap();
    let (q, v) = system.initial_state();
    system.state(0.0, &q, &v, None);
    let before = system.kinetic_energy() + system.potential_energy();
    let state = run(&mut system, 2.0, 1e-10);
    system.state(state.t, &state.q, &state.v, None);
    let after = system.kinetic_energy() + system.potential_energy();
    // Second order: 2e-2 J at an error of 1e-6, 1.2e-3 J at 1e-8 (steps 4.6 times smaller), so
    // about 6e-5 J here.
    assert!((after - before).abs() < 2e-4, "{before} J became {after} J");
    assert!(system.kinetic_energy() > 5.0, "it should be moving");
    let mut phi = vec![0.0; system.constraints()];
    system.constraint_residual(state.t, &state.q, &mut phi).unwrap();
    assert!(phi.iter().all(|phi| phi.abs() < 1e-9), "{phi:?}");
}

/// Truth: a bar driven at constant rate for three turns is where the function says, and its hinge
/// carries m r w^2 towards the axis beside the weight.
#[test]
fn driven_bar_makes_whole_turns() {
    let rate = 3.0 * TAU + 0.25;
    let mut turning = bar(0.0, DVec3::ZERO);
    turning.initial.w_gb_b = DVec3::new(0.0, 0.0, rate);
    turning.initial.v_gb_g = DVec3::new(0.5 * rate, 0.0, 0.0);
    let frames = vec![end(0, 0.5), ground()];
    let joint = Pair::revolute(".m.joint".into(), &frames, FrameId(0), FrameId(1));
    let function = Box::new(move |t: f64| [rate * t, rate, 0.0]);
    let motion = Driven::new(".m.motion".into(), &frames, FrameId(0), FrameId(1), Drive::Rotation, function);
    let joints: Vec<Box<dyn Constraint>> = vec![Box::new(joint), Box::new(motion)];
    let mut system = System::new(vec![turning], frames, Vec::new(), joints, DVec3::new(0.0, -G, 0.0)).unwrap();
    let state = run(&mut system, 1.0, 1e-6);
    let now = system.state(state.t, &state.q, &state.v, Some(&state.a));
    let angle = measures::angle(now, equations::Axis::Z, FrameId(0), Some(FrameId(1)), 3.0 * TAU, None);
    // Constraints hold to the accuracy of Newton's method.
    assert!((angle - rate).abs() < 1e-8, "{angle}");
    let along = now.frame(FrameId(0)).rot_gi.col(1);
    let pull = system.reaction(0, &state.lambda, Side::I).f_g;
    let wanted = along * (2.5 * 0.5 * rate * rate) + DVec3::new(0.0, 2.5 * G, 0.0);
    // The velocity is a projected result of the integrator: relative error about 1e-6.
    assert!((pull - wanted).length() < 1e-4 * wanted.length(), "{pull} is not {wanted}");
}

/// Truth: a unit of length is a matter of writing: as long as the model is larger than its unit, a
/// run in millimetres takes the steps of the run in metres, and those of the same model far away.
#[test]
fn the_unit_of_length_does_not_change_the_steps() {
    let swing = |unit: f64, away: DVec3| {
        let mut bar = bar(1.2, away);
        bar.initial.r_gb_g = away + DQuat::from_rotation_z(1.2) * DVec3::new(0.0, -4.0, 0.0);
        bar.inertia_c_b *= 64.0;
        let base = Frame { r_bi_b: away, ..ground() };
        let frames = vec![end(0, 4.0), base];
        let joint = Pair::revolute(".m.joint".into(), &frames, FrameId(0), FrameId(1));
        let gravity = DVec3::new(0.0, -G, 0.0);
        let mut system = System::new(vec![bar], frames, Vec::new(), vec![Box::new(joint)], gravity).unwrap();
        system.set_length_unit(unit);
        let (q, v) = system.initial_state();
        let mut state = SystemState::at_rest(&system, 0.0, q);
        state.v = v;
        let options = IntegratorOptions { hmax: Some(1.0), ..IntegratorOptions::default() };
        let work = integrate(&mut system, &mut state, 4.0, &[4.0], &options, &mut Silent).unwrap();
        (work.steps, work.iterations, state.q[0] - away.x)
    };
    let metres = swing(1.0, DVec3::ZERO);
    let millimetres = swing(1e-3, DVec3::ZERO);
    let far = swing(1e-3, DVec3::new(300.0, -20.0, 5.0));
    assert_eq!(metres, millimetres);
    // Not bit for bit: coordinates are rounded differently there.
    assert_eq!(metres.0, far.0);
    assert!((metres.2 - far.2).abs() < 1e-9, "{metres:?} {far:?}");
    assert!(metres.0 > 50, "the error and not the output decides the steps: {metres:?}");
}
