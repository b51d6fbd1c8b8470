//! Kinematic measures: gradients against differences, values against documented vectors and
//! against derivatives of simpler measures.

extern crate flexure_equations as equations;

mod common;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use common::{FLOOR, Random, assert_all_close, body, frame, slope};
use equations::{Axis, BodyId, Frame, FrameId, GROUND, Gradient, State, System, measures};
use glam::{DMat3, DVec3};
use solver::Dae;

const I: FrameId = FrameId(0);
const J: FrameId = FrameId(1);
const K: FrameId = FrameId(2);
const L: FrameId = FrameId(3);

/// Bodies and frames only; frame I has a point mass, K and L are on the same body if `shared`.
fn scene(random: &mut Random, shared: bool) -> System {
    let bodies: Vec<_> = (0..4).map(|at| body(&format!(".m.b{at}"), random, at == 3)).collect();
    let owners = if shared { [3, 1, 1, 0] } else { [0, 1, 2, 3] };
    let frames: Vec<_> = owners.iter().map(|&owner| frame(".m.f", BodyId(owner), random)).collect();
    System::new(bodies, frames, Vec::new(), Vec::new(), DVec3::ZERO).unwrap()
}

type Measure = Box<dyn Fn(&State, Option<&mut Gradient>) -> f64>;

fn all_measures(j: Option<FrameId>, k: Option<FrameId>, l: Option<FrameId>) -> Vec<(String, Measure)> {
    let mut list: Vec<(String, Measure)> = Vec::new();
    for axis in Axis::ALL {
        let name = |what: &str| format!("{what}{}", axis.letter());
        list.push((name("D"), Box::new(move |s, g| measures::displacement(s, axis, I, j, k, g))));
        list.push((name("V"), Box::new(move |s, g| measures::velocity(s, axis, I, j, k, l, g))));
        list.push((name("W"), Box::new(move |s, g| measures::angular_velocity(s, axis, I, j, k, g))));
        list.push((name("A"), Box::new(move |s, g| measures::angle(s, axis, I, j, 0.0, g))));
    }
    for which in 0..3 {
        list.push((format!("313 {which}"), Box::new(move |s, g| measures::angle_313(s, which, I, j, 0.0, g))));
        list.push((format!("YPR {which}"), Box::new(move |s, g| measures::yaw_pitch_roll(s, which, I, j, 0.0, g))));
    }
    list.push(("DM".into(), Box::new(move |s, g| measures::distance(s, I, j, g))));
    list.push(("VM".into(), Box::new(move |s, g| measures::speed(s, I, j, l, g))));
    list.push(("VR".into(), Box::new(move |s, g| measures::radial_velocity(s, I, j, l, g))));
    list.push(("WM".into(), Box::new(move |s, g| measures::angular_speed(s, I, j, g))));
    list.push(("INCANG".into(), Box::new(move |s, g| measures::included_angle(s, I, J, K, g))));
    list
}

/// Twin: differences of the value, for every measure, with and without frames left out.
#[test]
fn gradients_are_derivatives() {
    for (seed, shared, j, k, l) in
        [(1, false, Some(J), Some(K), Some(L)), (2, true, Some(J), Some(K), Some(L)), (3, false, None, None, None)]
    {
        let mut system = scene(&mut Random(seed), shared);
        let (q, v) = system.initial_state();
        for (name, measure) in all_measures(j, k, l) {
            let mut gradient = Gradient::new();
            measure(system.state(0.0, &q, &v, None), Some(&mut gradient));
            for at in 0..system.bodies().len() {
                let slot = system.layout().bodies[at];
                let got = gradient.of(BodyId(at as u32));
                for component in 0..2 * slot.size {
                    let (part, c) = (component / slot.size, component % slot.size);
                    let wanted = slope(|h| {
                        let mut step = vec![0.0; v.len()];
                        step[slot.velocity + c] = h;
                        let (mut q_h, mut v_h) = (q.clone(), v.clone());
                        if part == 0 {
                            system.retract(&q, &step, &mut q_h);
                        } else {
                            v_h[slot.velocity + c] += h;
                        }
                        vec![measure(system.state(0.0, &q_h, &v_h, None), None)]
                    });
                    let what = format!("{name}, seed {seed}, body {at}, part {part}, component {c}");
                    assert_all_close(&[got[6 * part + c]], &wanted, FLOOR, &what);
                }
            }
        }
    }
}

/// Twin: the functions of velocity and acceleration are derivatives in time of those of position,
/// when the axes are those of the frame in which the derivative is taken.
#[test]
fn velocities_and_accelerations_are_time_derivatives() {
    let mut random = Random(5);
    let mut system = scene(&mut random, false);
    let (q, v) = system.initial_state();
    let a = random.numbers(v.len());
    let (j, l) = (Some(J), Some(L));
    let moved = |system: &System, h: f64| {
        let step: Vec<f64> = v.iter().zip(&a).map(|(v, a)| h * v + 0.5 * h * h * a).collect();
        let faster: Vec<f64> = v.iter().zip(&a).map(|(v, a)| v + h * a).collect();
        let mut q_h = q.clone();
        system.retract(&q, &step, &mut q_h);
        (q_h, faster)
    };
    let vector = |f: &dyn Fn(Axis) -> f64| Axis::ALL.map(f).to_vec();
    let mut rate_of = |f: &dyn Fn(&State, Axis) -> f64| {
        slope(|h| {
            let (q_h, v_h) = moved(&system, h);
            let state = system.state(0.0, &q_h, &v_h, None);
            vector(&|axis| f(state, axis))
        })
    };
    let d_rate = rate_of(&|s, axis| measures::displacement(s, axis, I, j, l, None));
    let v_rate = rate_of(&|s, axis| measures::velocity(s, axis, I, j, l, l, None));
    let w_rate = rate_of(&|s, axis| measures::angular_velocity(s, axis, I, j, l, None));
    let dm_rate = rate_of(&|s, _| measures::distance(s, I, j, None));
    let state = system.state(0.0, &q, &v, Some(&a));
    assert_all_close(&vector(&|axis| measures::velocity(state, axis, I, j, l, l, None)), &d_rate, FLOOR, "V");
    assert_all_close(&measures::acceleration(state, I, j, l, l).to_array(), &v_rate, FLOOR, "ACC");
    assert_all_close(&measures::angular_acceleration(state, I, j, l, l).to_array(), &w_rate, FLOOR, "WDT");
    assert_all_close(&[measures::radial_velocity(state, I, j, l, None)], &dm_rate[..1], FLOOR, "VR");
    let v_l = vector(&|axis| measures::velocity(state, axis, I, j, None, l, None));
    let length = v_l.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert_all_close(&[measures::speed(state, I, j, l, None)], &[length], 1e-14, "VM");
}

/// State with I at a position and orientation in ground, J at the origin with its own.
fn placed(r_i: DVec3, rot_i: DMat3, rot_j: DMat3) -> State {
    let on_ground = |r: DVec3, rot| Frame { name: String::new(), body: GROUND, r_bi_b: r, rot_bi: rot };
    let frames = vec![on_ground(r_i, rot_i), on_ground(DVec3::ZERO, rot_j), on_ground(DVec3::Y, DMat3::IDENTITY)];
    let mut system = System::new(Vec::new(), frames, Vec::new(), Vec::new(), DVec3::ZERO).unwrap();
    system.state(0.0, &[], &[], None).clone()
}

/// Truth: J turned by 90 degrees about z sees a point on the ground's x axis on its own -y axis.
#[test]
fn displacement_in_turned_axes() {
    let state = placed(DVec3::X, DMat3::IDENTITY, DMat3::from_rotation_z(FRAC_PI_2));
    let d = Axis::ALL.map(|axis| measures::displacement(&state, axis, I, Some(J), Some(J), None));
    assert_all_close(&d, &[0.0, -1.0, 0.0], 1e-15, "DX DY DZ");
    assert_eq!(measures::distance(&state, I, Some(J), None), 1.0);
    // From J at the origin I lies along x and K along y.
    assert_eq!(measures::included_angle(&state, I, J, K, None), FRAC_PI_2);
}

/// Truth: a rotation about one axis of J is seen as that angle, counterclockwise positive.
#[test]
fn projected_angles_have_their_sign() {
    let turn = [DMat3::from_rotation_x, DMat3::from_rotation_y, DMat3::from_rotation_z];
    for (axis, turn) in Axis::ALL.into_iter().zip(turn) {
        let rot_j = DMat3::from_rotation_y(0.4) * DMat3::from_rotation_x(-1.1);
        let state = placed(DVec3::X, rot_j * turn(0.7), rot_j);
        for other in Axis::ALL {
            let wanted = if other == axis { 0.7 } else { 0.0 };
            let got = measures::angle(&state, other, I, Some(J), 0.0, None);
            assert!((got - wanted).abs() < 1e-15, "{axis:?} seen about {other:?}: {got}");
        }
        let unwound = measures::angle(&state, axis, I, Some(J), 5.0 * TAU + 3.0, None);
        assert!((unwound - (5.0 * TAU + 0.7)).abs() < 1e-14, "turns are lost: {unwound}");
    }
}

/// Truth: the angles that the orientation was made of, R = Rz Rx Rz and R = Rz Ry Rx.
#[test]
fn body_angles_come_back() {
    let (z, x, y) = (DMat3::from_rotation_z, DMat3::from_rotation_x, DMat3::from_rotation_y);
    let angles = [2.1, 0.8, -1.4];
    let state = placed(DVec3::X, z(angles[0]) * x(angles[1]) * z(angles[2]), DMat3::IDENTITY);
    let got = [0, 1, 2].map(|which| measures::angle_313(&state, which, I, None, angles[which], None));
    assert_all_close(&got, &angles, 1e-15, "3-1-3");
    let state = placed(DVec3::X, z(angles[0]) * y(angles[1]) * x(angles[2]), DMat3::IDENTITY);
    let got = [0, 1, 2].map(|which| measures::yaw_pitch_roll(&state, which, I, None, angles[which], None));
    assert_all_close(&got, &[2.1, -0.8, -1.4], 1e-15, "yaw, pitch, roll: pitch is minus the second angle");
    // Parallel z axes: the first angle takes the turn, the last is 0.
    let state = placed(DVec3::X, z(2.1), DMat3::IDENTITY);
    let got = [0, 1, 2].map(|which| measures::angle_313(&state, which, I, None, 0.0, None));
    assert_all_close(&got, &[2.1, 0.0, 0.0], 1e-15, "3-1-3 with parallel axes");
    assert!((measures::nearest(-3.0, PI) - (TAU - 3.0)).abs() < 1e-15);
}
