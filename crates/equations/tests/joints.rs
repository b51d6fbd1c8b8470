//! Joints: how many equations, what they allow and forbid, their names, their loads.

extern crate flexure_equations as equations;

mod common;

use std::f64::consts::FRAC_PI_2;

use common::{Random, assert_all_close, body, frame};
use equations::constraints::{Drive, Driven, Pair};
use equations::{Axis, BodyId, Constraint, Frame, FrameId, GROUND, Side, State, System};
use glam::{DMat3, DVec3};
use solver::Dae;

type Maker = fn(String, &[Frame], FrameId, FrameId) -> Pair;

/// Name, constructor, equations, motions of I in J that are allowed (translation x y z, rotation
/// x y z), whether z of I starts perpendicular to z of J.
#[rustfmt::skip]
const JOINTS: [(&str, Maker, usize, [u8; 6], bool); 14] = [
    ("fixed",         Pair::fixed,         6, [0, 0, 0, 0, 0, 0], false),
    ("revolute",      Pair::revolute,      5, [0, 0, 0, 0, 0, 1], false),
    ("translational", Pair::translational, 5, [0, 0, 1, 0, 0, 0], false),
    ("cylindrical",   Pair::cylindrical,   4, [0, 0, 1, 0, 0, 1], false),
    ("spherical",     Pair::spherical,     3, [0, 0, 0, 1, 1, 1], false),
    ("planar",        Pair::planar,        3, [1, 1, 0, 0, 0, 1], false),
    ("universal",     Pair::universal,     4, [0, 0, 0, 0, 1, 1], true),
    ("hooke",         Pair::hooke,         4, [0, 0, 0, 1, 1, 0], false),
    ("at_point",      Pair::at_point,      3, [0, 0, 0, 1, 1, 1], false),
    ("inline",        Pair::inline,        2, [0, 0, 1, 1, 1, 1], false),
    ("inplane",       Pair::inplane,       1, [1, 1, 0, 1, 1, 1], false),
    ("orientation",   Pair::orientation,   3, [1, 1, 1, 0, 0, 0], false),
    ("parallel_axes", Pair::parallel_axes, 2, [1, 1, 1, 0, 0, 1], false),
    ("perpendicular", Pair::perpendicular, 1, [1, 1, 1, 0, 1, 1], true),
];

/// Two bodies; J on the second, I on the first such that in J it stands at `d` with `rot`.
fn pair(maker: Maker, d: DVec3, rot: DMat3) -> System {
    let mut random = Random(3);
    let bodies = vec![body(".m.a", &mut random, false), body(".m.b", &mut random, false)];
    let j = frame(".m.j", BodyId(1), &mut random);
    let place = |body: usize| (bodies[body].initial.r_gb_g, DMat3::from_quat(bodies[body].initial.q_gb));
    let ((r_a, rot_a), (r_b, rot_b)) = (place(0), place(1));
    let rot_gj = rot_b * j.rot_bi;
    let r_gi = r_b + rot_b * j.r_bi_b + rot_gj * d;
    let i = Frame {
        name: ".m.i".into(),
        body: BodyId(0),
        r_bi_b: rot_a.transpose() * (r_gi - r_a),
        rot_bi: rot_a.transpose() * rot_gj * rot,
    };
    let frames = vec![i, j];
    let joint = maker(".m.joint".into(), &frames, FrameId(0), FrameId(1));
    System::new(bodies, frames, Vec::new(), vec![Box::new(joint)], DVec3::ZERO).unwrap()
}

fn violation(system: &mut System) -> f64 {
    let (q, _) = system.initial_state();
    let mut phi = vec![0.0; system.constraints()];
    system.constraint_residual(0.0, &q, &mut phi).unwrap();
    phi.iter().fold(0.0, |most: f64, phi| most.max(phi.abs()))
}

fn rank(mut rows: Vec<Vec<f64>>) -> usize {
    let mut rank = 0;
    let width = rows.first().map_or(0, Vec::len);
    for column in 0..width {
        let Some(pivot) = (rank..rows.len()).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))
        else {
            break;
        };
        if rows[pivot][column].abs() < 1e-9 {
            continue;
        }
        rows.swap(rank, pivot);
        for row in rank + 1..rows.len() {
            let factor = rows[row][column] / rows[rank][column];
            let (head, tail) = rows.split_at_mut(row);
            for (value, above) in tail[0].iter_mut().zip(&head[rank]) {
                *value -= factor * above;
            }
        }
        rank += 1;
    }
    rank
}

/// Truth: the table of joints. Rounding of positions of order 1 leaves 1e-15.
#[test]
fn joints_allow_what_they_should_and_nothing_else() {
    let turn = [DMat3::from_rotation_x, DMat3::from_rotation_y, DMat3::from_rotation_z];
    for (name, maker, equations, allowed, crossed) in JOINTS {
        let start = if crossed { DMat3::from_rotation_x(FRAC_PI_2) } else { DMat3::IDENTITY };
        let mut system = pair(maker, DVec3::ZERO, start);
        assert_eq!(system.constraints(), equations, "{name}");
        assert!(violation(&mut system) < 3e-15, "{name} is violated at its start");
        let (q, _) = system.initial_state();
        let rows = system.constraint_rows(0.0, &q).unwrap();
        let dense = rows.iter().map(|row| {
            let mut full = vec![0.0; 12];
            row.entries.iter().for_each(|&(column, value)| full[column] = value);
            full
        });
        assert_eq!(rank(dense.collect()), equations, "{name}: rank");
        assert_eq!(6 - allowed.iter().map(|&free| usize::from(free)).sum::<usize>(), equations, "{name}: count");
        for (motion, free) in allowed.iter().enumerate() {
            let (d, rot) = if motion < 3 {
                (0.3 * DVec3::AXES[motion], start)
            } else {
                (DVec3::ZERO, turn[motion - 3](0.3) * start)
            };
            let violation = violation(&mut pair(maker, d, rot));
            assert_eq!(violation < 3e-15, *free == 1, "{name}, motion {motion}: {violation}");
        }
    }
}

#[test]
fn equations_have_the_names_of_reports() {
    let frames = [frame("i", GROUND, &mut Random(1)), frame("j", GROUND, &mut Random(2))];
    let joint = Pair::revolute(".m.hinge".into(), &frames, FrameId(0), FrameId(1));
    let names: Vec<_> = (0..5).map(|at| joint.equation_name(at).0).collect();
    assert_eq!(names, ["X", "Y", "Z", "Zi.Xj", "Zi.Yj"]);
    assert_eq!(joint.equation_name(3).1, "Rotation Between Zi & Xj");
    assert_eq!(joint.equation_name(0).1, "Translation Along Xj");
    assert_eq!(joint.kind(), "Revolute Joint");
}

/// Truth: internal loads have no resultant. Any multipliers, joints far from satisfied.
#[test]
fn loads_on_both_ends_balance() {
    let mut random = Random(9);
    for (name, maker, equations, ..) in JOINTS {
        let mut system = pair(maker, random.vector(), DMat3::from_quat(random.rotation()));
        let (q, v) = system.initial_state();
        let state = system.state(0.0, &q, &v, None).clone();
        let lambda = random.numbers(equations);
        let [i, j] = [Side::I, Side::J].map(|side| system.reaction(0, &lambda, side));
        let (r_i, r_j) = (state.frames[0].r_gi_g, state.frames[1].r_gi_g);
        assert_eq!(i.f_g + j.f_g, DVec3::ZERO, "{name}");
        let moment = i.t_g + j.t_g + r_i.cross(i.f_g) + r_j.cross(j.f_g);
        assert!(moment.length() < 1e-14, "{name}: {moment}");
        // The same loads, seen through B: minus the residual of a system at rest.
        system.set_statics(true);
        let mut r = vec![0.0; 12];
        system.residual(0.0, &q, &v, &[0.0; 12], &lambda, &mut r).unwrap();
        for (at, load) in [i, j].into_iter().enumerate() {
            let torque = state.rotations[at].transpose() * (load.t_g + state.frames[at].r_bi_g.cross(load.f_g));
            let wanted = [-load.f_g, -torque].map(|vector| vector.to_array()).concat();
            assert_all_close(&r[6 * at..6 * at + 6], &wanted, 1e-14, name);
        }
    }
}

/// Accelerations and multipliers of `[M B^T; B 0] [a; lambda] = [-r(a = 0); -gamma]`.
fn accelerations(system: &mut System, q: &[f64], v: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (nv, nl) = (system.velocities(), system.constraints());
    let (zero_a, zero_l) = (vec![0.0; nv], vec![0.0; nl]);
    let (mut r, mut gamma) = (zero_a.clone(), zero_l.clone());
    system.residual(0.0, q, v, &zero_a, &zero_l, &mut r).unwrap();
    system.constraint_acceleration(0.0, q, v, &mut gamma).unwrap();
    let point =
        solver::JacobianPoint { t: 0.0, q, v, a: &zero_a, lambda: &zero_l, mass: 1.0, damping: 0.0, stiffness: 0.0 };
    let mut rows = common::dense(system, point);
    for (row, value) in rows.iter_mut().zip(r.iter().chain(&gamma)) {
        row.push(-value);
    }
    let size = nv + nl;
    for column in 0..size {
        let pivot = (column..size).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs())).unwrap();
        rows.swap(column, pivot);
        for row in 0..size {
            if row != column {
                let factor = rows[row][column] / rows[column][column];
                let above = rows[column].clone();
                rows[row].iter_mut().zip(&above).for_each(|(value, above)| *value -= factor * above);
            }
        }
    }
    let mut x: Vec<f64> = (0..size).map(|row| rows[row][size] / rows[row][row]).collect();
    let lambda = x.split_off(nv);
    (x, lambda)
}

/// A pendulum in the x-y plane: length `l` from the hinge at the ground's origin to the centre of
/// mass, at `phi` from straight down, turning at `rate`. Frame 0 on the bar, frame 1 on ground.
fn pendulum(l: f64, phi: f64, rate: f64) -> (System, Vec<f64>, Vec<f64>) {
    let mut random = Random(4);
    let mut bar = body(".m.bar", &mut random, false);
    bar.inertia_c_b = DMat3::from_diagonal(DVec3::new(0.2, 0.3, 0.4));
    let rot = DMat3::from_rotation_z(phi);
    bar.initial = common::motion(
        rot * DVec3::new(0.0, -l, 0.0),
        glam::DQuat::from_rotation_z(phi),
        rot * DVec3::new(rate * l, 0.0, 0.0),
        DVec3::new(0.0, 0.0, rate),
    );
    let hinge = |body, r| Frame { name: ".m.hinge".into(), body, r_bi_b: r, rot_bi: DMat3::IDENTITY };
    let frames = vec![hinge(BodyId(0), DVec3::new(0.0, l, 0.0)), hinge(GROUND, DVec3::ZERO)];
    let joint = Pair::revolute(".m.joint".into(), &frames, FrameId(0), FrameId(1));
    let gravity = DVec3::new(0.0, -9.80665, 0.0);
    let system = System::new(vec![bar], frames, Vec::new(), vec![Box::new(joint)], gravity).unwrap();
    let (q, v) = system.initial_state();
    (system, q, v)
}

/// Truth: physical pendulum, phi'' = -m g l sin phi / (I + m l^2); along the bar the hinge pulls
/// m g cos phi + m l rate^2, across it m g sin phi + m l phi''.
#[test]
fn hinge_of_a_pendulum_pulls_as_in_the_textbook() {
    let (m, l, g, phi, rate) = (2.5, 0.8, 9.80665_f64, 0.6_f64, 1.7);
    let (mut system, q, v) = pendulum(l, phi, rate);
    let (a, lambda) = accelerations(&mut system, &q, &v);
    let turning = -m * g * l * phi.sin() / (0.4 + m * l * l);
    assert_all_close(&[a[5]], &[turning], 1e-13, "angular acceleration");
    system.state(0.0, &q, &v, None);
    let on_bar = system.reaction(0, &lambda, Side::I);
    let to_bar = DMat3::from_rotation_z(-phi);
    let along = m * g * phi.cos() + m * l * rate * rate;
    let across = m * g * phi.sin() + m * l * turning;
    assert_all_close(&(to_bar * on_bar.f_g).to_array(), &[across, along, 0.0], 1e-13, "on the bar");
    let on_ground = system.reaction(0, &lambda, Side::J);
    assert_all_close(&(to_bar * on_ground.f_g).to_array(), &[-across, -along, 0.0], 1e-13, "on ground");
    assert_all_close(&on_bar.t_g.to_array(), &[0.0; 3], 1e-12, "no torque");
    let energy = system.kinetic_energy() + system.potential_energy();
    let wanted = 0.5 * (0.4 + m * l * l) * rate * rate - m * g * l * phi.cos();
    assert_all_close(&[energy], &[wanted], 1e-14, "energy");
    assert_eq!((system.total_mass(), system.elastic_energy()), (m, 0.0));
}

/// Truth: a motion on the hinge needs the torque I phi'' + m g l sin phi on the bar about z, and
/// the multiplier's load on the body of I is that torque.
#[test]
fn motion_on_a_hinge_needs_the_textbook_torque() {
    let (m, l, g, phi, rate) = (2.5, 0.8, 9.80665_f64, 0.6_f64, 1.7);
    let (plain, q, v) = pendulum(l, phi, rate);
    let frames = plain.frames().to_vec();
    let joint = Pair::revolute(".m.joint".into(), &frames, FrameId(0), FrameId(1));
    // The function has made three turns more than the wrapped angle.
    let turns = 3.0 * std::f64::consts::TAU;
    let function = Box::new(move |t: f64| [turns + phi + rate * t + 2.0 * t * t, rate + 4.0 * t, 4.0]);
    let motion = Driven::new(".m.motion".into(), &frames, FrameId(0), FrameId(1), Drive::Rotation, function);
    let mut system = System::new(
        plain.bodies().to_vec(),
        frames,
        Vec::new(),
        vec![Box::new(joint), Box::new(motion)],
        plain.gravity_g(),
    )
    .unwrap();
    let mut phi_now = vec![0.0; 6];
    system.constraint_residual(0.0, &q, &mut phi_now).unwrap();
    assert_all_close(&phi_now, &[0.0; 6], 1e-14, "three turns are no violation");
    system.constraint_residual(0.1, &q, &mut phi_now).unwrap();
    assert_all_close(&[phi_now[5]], &[-(0.17 + 0.02)], 1e-14, "behind the function");
    let (a, lambda) = accelerations(&mut system, &q, &v);
    assert_all_close(&[a[5]], &[4.0], 1e-13, "angular acceleration");
    system.state(0.0, &q, &v, None);
    let torque = system.reaction(1, &lambda, Side::I).t_g;
    let wanted = (0.4 + m * l * l) * 4.0 + m * g * l * phi.sin();
    assert_all_close(&torque.to_array(), &[0.0, 0.0, wanted], 1e-13, "torque");
}

/// A driven angle that is not defined, and a function that is not finite, are errors by name.
#[test]
fn impossible_motions_say_who_they_are() {
    let (plain, q, _) = pendulum(1.0, 0.0, 0.0);
    let frames = plain.frames().to_vec();
    let with = |drive: Drive, function: fn(f64) -> [f64; 3]| -> String {
        let motion = Driven::new(".m.motion".into(), &frames, FrameId(0), FrameId(1), drive, Box::new(function));
        let mut system =
            System::new(plain.bodies().to_vec(), frames.clone(), Vec::new(), vec![Box::new(motion)], DVec3::ZERO)
                .unwrap();
        system.constraint_residual(0.5, &q, &mut [0.0]).unwrap_err().message
    };
    let message = with(Drive::Translation(Axis::X), |_| [f64::NAN, 0.0, 0.0]);
    assert_eq!(message, "the function of `.m.motion` is NaN at time 0.5");
}

/// Opposite axes satisfy the equations of a hinge; the joint says so.
#[test]
fn opposite_axes_are_a_concern() {
    let opposite = DMat3::from_rotation_x(std::f64::consts::PI);
    for (rot, concerned) in [(DMat3::IDENTITY, false), (opposite, true)] {
        let mut system = pair(Pair::revolute, DVec3::ZERO, rot);
        assert!(violation(&mut system) < 3e-15);
        let (q, v) = system.initial_state();
        let state: State = system.state(0.0, &q, &v, None).clone();
        assert_eq!(system.constraint_list()[0].concern(&state).is_some(), concerned);
    }
}

/// A frame on a body that does not exist is refused, not an index out of range later.
#[test]
fn missing_bodies_are_refused() {
    let frames = vec![frame(".m.lost", BodyId(3), &mut Random(1))];
    let error = System::new(Vec::new(), frames, Vec::new(), Vec::new(), DVec3::ZERO).err().unwrap();
    assert!(error.message.contains(".m.lost"), "{}", error.message);
}
