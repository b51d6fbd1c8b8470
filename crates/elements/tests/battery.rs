//! The checks every force must pass: its derivative is that of its load, action and reaction
//! balance, and moving the whole scene rigidly moves the load with it.

mod common;

use common::Build;
use flexure_elements::{Options, lower};
use glam::{DMat3, DQuat, DVec3};
use model::ObjectId;
use schema::UnitSystem;
use solver::{Dae, JacobianPoint};

/// Two free parts with a marker each, away from the centres and turned.
fn two_parts() -> (Build, ObjectId, ObjectId) {
    let mut b = Build::new(UnitSystem::mmks());
    let first = b.part("first", [0.0; 3], 2.0, 100.0);
    let second = b.part("second", [400.0, 20.0, -10.0], 3.0, 200.0);
    let j = b.marker(first, "j", [50.0, 10.0, -20.0]);
    let i = b.marker(second, "i", [30.0, -25.0, 15.0]);
    b.numbers(j, "orientation", &[10.0, 20.0, 5.0]);
    b.numbers(i, "orientation", &[5.0, 25.0, 12.0]);
    (b, i, j)
}

fn beam(formulation: &str) -> Build {
    let (mut b, i, j) = two_parts();
    let beam = b.beam("force", i, j, 400.0);
    b.word(beam, "formulation", formulation);
    b
}

fn single(kind: &str, action_only: bool, function: &str) -> Build {
    let (mut b, i, j) = two_parts();
    let force = b.add("single_component_force", b.model, "force");
    b.refer(force, "i_marker_name", i);
    b.refer(force, "j_marker_name", j);
    b.word(force, "type_of_freedom", kind);
    b.database.set_value(force, "action_only", model::Value::Flag(action_only));
    b.function(force, "function", function);
    b
}

/// A bushing with all its numbers, or a spring and damper.
fn elastic(class: &str) -> Build {
    let (mut b, i, j) = two_parts();
    let force = b.add(class, b.model, "force");
    b.refer(force, "i_marker_name", i);
    b.refer(force, "j_marker_name", j);
    if class == "bushing" {
        for (cell, values) in [
            ("stiffness", [5.0, 6.0, 7.0]),
            ("damping", [0.3, 0.2, 0.1]),
            ("force_preload", [10.0, -20.0, 30.0]),
            ("tstiffness", [300.0, 400.0, 500.0]),
            ("tdamping", [5.0, 6.0, 7.0]),
            ("torque_preload", [1000.0, 2000.0, -500.0]),
        ] {
            b.numbers(force, cell, &values);
        }
    } else {
        let turns = class == "rotational_spring_damper";
        // 2E4 newton-mm and 300 newton-mm-s per radian, given per degree.
        let radian = if turns { std::f64::consts::PI / 180.0 } else { 1.0 };
        b.set(force, "stiffness", if turns { 2e4 * radian } else { 5.0 });
        b.set(force, "damping", if turns { 300.0 * radian } else { 0.3 });
        b.set(force, "displacement_at_preload", if turns { 0.0 } else { 380.0 });
    }
    b
}

const SPRING: &str = "-5*(DM(.m.second.i,.m.first.j)-380) - 0.3*VR(.m.second.i,.m.first.j)";
const TWIST: &str = "-2E4*AZ(.m.second.i,.m.first.j) - 300*WZ(.m.second.i,.m.first.j,.m.first.j)";
const MIXED: &str = "STEP(TIME,0,0,1,4)*DX(.m.second.i,.m.first.j,.m.second.cm)+VY(.m.second.i,.m.first.j,.m.first.cm)";

/// A force that asks for loads of a beam which is created after it: sizes and components, at both
/// ends, in the axes of either part, of force and torque. Factors make all terms count.
fn reading(formulation: &str) -> Build {
    let mut b = single("translational", false, "0");
    let markers = [".m.second.i", ".m.first.j"].map(|name| b.database.find(name, "marker").unwrap());
    let beam = b.beam("bar", markers[0], markers[1], 400.0);
    b.word(beam, "formulation", formulation);
    b.set(beam, "damping_ratio", 0.1);
    let force = b.database.find(".m.force", "single_component_force").unwrap();
    b.function(
        force,
        "function",
        "BEAM(.m.bar,0,2,.m.second.cm) + 2*BEAM(.m.bar,1,1) - BEAM(.m.bar,1,3,.m.first.j) \
         + 0.01*BEAM(.m.bar,0,5) - 0.02*BEAM(.m.bar,1,7,.m.second.i) + 0.03*BEAM(.m.bar,0,8,.m.first.cm)",
    );
    b
}

fn all() -> Vec<(&'static str, Build)> {
    vec![
        ("force of a linear beam's load", reading("linear")),
        ("force of a string beam's load", reading("string")),
        ("force of a nonlinear beam's load", reading("nonlinear")),
        ("linear beam", beam("linear")),
        ("string beam", beam("string")),
        ("nonlinear beam", beam("nonlinear")),
        ("spring", single("translational", false, SPRING)),
        ("torsion spring", single("rotational", false, TWIST)),
        ("bushing", elastic("bushing")),
        ("spring-damper", elastic("translational_spring_damper")),
        ("torsion spring-damper", elastic("rotational_spring_damper")),
        ("action-only force", single("translational", true, MIXED)),
    ]
}

/// A state near the built one, moving.
fn state(n: usize) -> Vec<f64> {
    (0..n).map(|k| 0.05 * ((k as f64 * 1.7 + 0.3).sin())).collect()
}

/// Twin: central differences of the residual. Steps of 1e-6 leave (1e-6)^2 of truncation and 1e-16
/// / 1e-6 of rounding, relative to the largest entry.
#[test]
fn the_derivative_is_that_of_the_load() {
    for (what, b) in all() {
        let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{what}: {d:?}"));
        let system = &mut lowered.system;
        let (q0, _) = system.initial_state();
        let n = system.velocities();
        let mut q = q0.clone();
        system.retract(&q0, &state(n), &mut q);
        let v = state(n + 3)[3..].to_vec();
        let zero = vec![0.0; n];
        let mut exact = vec![vec![vec![0.0; n]; n]; 2];
        for (part, (damping, stiffness)) in [(0.0, 1.0), (1.0, 0.0)].into_iter().enumerate() {
            let at = JacobianPoint { t: 0.7, q: &q, v: &v, a: &zero, lambda: &[], mass: 0.0, damping, stiffness };
            let matrix = &mut exact[part];
            system
                .jacobian(at, &mut |row, column, values| {
                    for (k, value) in values.iter().enumerate() {
                        matrix[6 * row + k % 6][6 * column + k / 6] += value;
                    }
                })
                .unwrap();
        }
        let mut largest = [0.0_f64; 2];
        let mut differences = vec![(0, 0, 0, 0.0); 0];
        for column in 0..n {
            for part in 0..2 {
                let mut side = |h: f64| {
                    let (mut q1, mut v1) = (q.clone(), v.clone());
                    if part == 0 {
                        let mut increment = zero.clone();
                        increment[column] = h;
                        system.retract(&q, &increment, &mut q1);
                    } else {
                        v1[column] += h;
                    }
                    let mut r = vec![0.0; n];
                    system.residual(0.7, &q1, &v1, &zero, &[], &mut r).unwrap();
                    r
                };
                let h = 1e-6;
                let (plus, minus) = (side(h), side(-h));
                for row in 0..n {
                    largest[part] = largest[part].max(exact[part][row][column].abs());
                    differences.push((part, row, column, (plus[row] - minus[row]) / (2.0 * h)));
                }
            }
        }
        assert!(largest[0] > 0.0, "{what} has no stiffness");
        for (part, row, column, difference) in differences {
            let value = exact[part][row][column];
            let tolerance = 2e-7 * largest[part].max(largest[0] * 1e-3);
            assert!((value - difference).abs() <= tolerance, "{what} {part} {row} {column}: {value} {difference}");
        }
    }
}

/// Truth: internal forces change neither momentum; all but the action-only force are internal.
#[test]
fn action_and_reaction_balance() {
    for (what, b) in all().into_iter().filter(|(what, _)| *what != "action-only force") {
        let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{what}: {d:?}"));
        let system = &mut lowered.system;
        let (q0, v) = system.initial_state();
        let n = system.velocities();
        let mut q = q0.clone();
        system.retract(&q0, &state(n), &mut q);
        let mut r = vec![0.0; n];
        system.residual(0.7, &q, &v, &vec![0.0; n], &[], &mut r).unwrap();
        let at = system.state(0.7, &q, &v, None);
        let (mut force, mut moment, mut size) = (DVec3::ZERO, DVec3::ZERO, 0.0_f64);
        for body in 0..2 {
            let (f, t) = (DVec3::from_slice(&r[6 * body..]), DVec3::from_slice(&r[6 * body + 3..]));
            force += f;
            moment += at.bodies[body].r_gb_g.cross(f) + at.rotations[body] * t;
            size = size.max(f.length()).max(t.length());
        }
        assert!(size > 0.0, "{what} does nothing");
        assert!(force.length() < 1e-12 * size && moment.length() < 1e-12 * size, "{what}: {force} {moment}");
    }
}

/// Truth: loads turn with the scene; rounding of a rotation is the tolerance.
#[test]
fn loads_move_with_the_scene() {
    let (turn, shift) =
        (DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1), DVec3::new(3.0, -2.0, 1.0));
    for (what, b) in all() {
        let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{what}: {d:?}"));
        let system = &mut lowered.system;
        let (q, v) = system.initial_state();
        let n = system.velocities();
        let zero = vec![0.0; n];
        let (mut moved, mut here, mut there) = (q.clone(), zero.clone(), zero.clone());
        for body in 0..2 {
            let at = 7 * body;
            let r = turn * DVec3::from_slice(&q[at..]) + shift;
            let o = turn * DQuat::from_xyzw(q[at + 4], q[at + 5], q[at + 6], q[at + 3]);
            moved[at..at + 3].copy_from_slice(&r.to_array());
            moved[at + 3..at + 7].copy_from_slice(&[o.w, o.x, o.y, o.z]);
        }
        system.residual(0.7, &q, &v, &zero, &[], &mut here).unwrap();
        system.residual(0.7, &moved, &v, &zero, &[], &mut there).unwrap();
        let rotation = DMat3::from_quat(turn);
        let size = here.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for body in 0..2 {
            let force = rotation * DVec3::from_slice(&here[6 * body..]) - DVec3::from_slice(&there[6 * body..]);
            let torque = DVec3::from_slice(&here[6 * body + 3..]) - DVec3::from_slice(&there[6 * body + 3..]);
            assert!(force.length().max(torque.length()) < 1e-11 * size, "{what}: {force} {torque} of {size}");
        }
    }
}

/// Twin: the same spring and damper as a single-component force with a function. Rounding of a few
/// products is the tolerance.
#[test]
fn spring_dampers_are_the_forces_of_their_functions() {
    for (class, kind, function) in
        [("translational_spring_damper", "translational", SPRING), ("rotational_spring_damper", "rotational", TWIST)]
    {
        let residual = |b: &Build| {
            let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
            let system = &mut lowered.system;
            let (q0, _) = system.initial_state();
            let n = system.velocities();
            let mut q = q0.clone();
            system.retract(&q0, &state(n), &mut q);
            let mut r = vec![0.0; n];
            system.residual(0.7, &q, &state(n), &vec![0.0; n], &[], &mut r).unwrap();
            r
        };
        let (one, other) = (residual(&elastic(class)), residual(&single(kind, false, function)));
        let size = one.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!(size > 0.0);
        for (a, b) in one.iter().zip(&other) {
            assert!((a - b).abs() < 1e-12 * size, "{class}: {a} is not {b}");
        }
    }
}
