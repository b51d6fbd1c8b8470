//! What every beam must do, whatever its theory and options: no load where it is undeformed, wherever it
//! is and however it moves; equal and opposite loads; the same load however the whole beam is turned; a
//! refusal by name where it has no direction.

mod common;

use common::Build;
use equations::System;
use flexure_elements::{Options, forces::beam::Angles, lower};
use glam::{DMat3, DQuat, DVec3};
use schema::UnitSystem;
use solver::Dae;

/// Length of the beam, m.
const LENGTH: f64 = 0.4;

/// Two free parts of point-like inertia with a beam between them, undeformed; J is turned in its part.
fn system(formulation: &str, shear: bool, vector: bool, matrix: bool) -> System {
    let mut b = Build::new(UnitSystem::mmks());
    let first = b.part("first", [0.0; 3], 2.0, 100.0);
    let second = b.part("second", [400.0, 0.0, 0.0], 3.0, 100.0);
    let (j, i) = (b.marker(first, "j", [0.0; 3]), b.marker(second, "i", [0.0; 3]));
    let beam = b.beam("bar", i, j, 1e3 * LENGTH);
    b.word(beam, "formulation", formulation);
    b.set(beam, "y_shear_area_ratio", 1.2);
    b.set(beam, "z_shear_area_ratio", 1.5);
    b.set(beam, "izz", 300.0);
    if matrix {
        let terms: Vec<f64> = (0..21).map(|n| 0.1 + 0.01 * f64::from(n)).collect();
        b.numbers(beam, "matrix_of_damping_terms", &terms);
    }
    let beam_angles = if vector { Angles::RotationVector } else { Angles::Projected };
    let options = Options { nonlinear_shear: shear, beam_angles, ..Options::default() };
    lower(&b.database, b.model, options).unwrap_or_else(|d| panic!("{d:?}")).system
}

fn all() -> Vec<(String, System)> {
    let mut found = Vec::new();
    for formulation in ["linear", "string", "nonlinear"] {
        for option in [false, true] {
            for matrix in [false, true] {
                found.push((format!("{formulation} {option} {matrix}"), system(formulation, option, option, matrix)));
            }
        }
    }
    found
}

/// Position and velocity of the two bodies, for `residual`: body k has its frame turned by `turns[k]`.
fn state(places: [DVec3; 2], turns: [DQuat; 2], v: [DVec3; 2], w_g: [DVec3; 2]) -> (Vec<f64>, Vec<f64>) {
    let mut q = Vec::new();
    let mut velocities = Vec::new();
    for k in 0..2 {
        let turn = turns[k];
        q.extend([places[k].x, places[k].y, places[k].z, turn.w, turn.x, turn.y, turn.z]);
        velocities.extend(v[k].to_array());
        velocities.extend((turn.conjugate() * w_g[k]).to_array());
    }
    (q, velocities)
}

/// Loads on both bodies: force in ground axes, torque in body axes, with the sign of the residual. Equal
/// inertias about all axes have no gyroscopic terms, so that nothing but the beam is in it.
fn loads(system: &mut System, state: &(Vec<f64>, Vec<f64>)) -> Result<[DVec3; 4], String> {
    let mut r = vec![0.0; 12];
    system.residual(0.0, &state.0, &state.1, &[0.0; 12], &[], &mut r).map_err(|e| e.message)?;
    Ok([0, 3, 6, 9].map(|k| DVec3::from_slice(&r[k..])))
}

/// Truth: an undeformed beam has no load, at rest or in any rigid motion. EA is 1.6e7 N, of which 1e-12 is
/// the rounding of positions and rotations.
#[test]
fn there_is_no_load_without_deformation() {
    for (what, mut system) in all() {
        for (k, axis) in
            [DVec3::X, DVec3::Y, DVec3::new(1.0, -2.0, 0.5), DVec3::new(-0.3, 0.4, 3.0)].into_iter().enumerate()
        {
            let turn = DQuat::from_axis_angle(axis.normalize(), 0.9 * (k + 1) as f64);
            let origin = DVec3::new(0.7, -3.0, 2.0) * k as f64;
            let arm = turn * DVec3::new(LENGTH, 0.0, 0.0);
            let (v, w) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(-2.0, 4.0, 1.0));
            let moving = state([origin, origin + arm], [turn; 2], [v, v + w.cross(arm)], [w; 2]);
            for load in loads(&mut system, &moving).unwrap() {
                assert!(load.length() < 1.6e7 * 1e-12, "{what} {k}: {load}");
            }
        }
    }
}

/// A deformed and moving beam, the whole of it turned about an axis by an angle.
fn deformed(axis: DVec3, angle: f64) -> (Vec<f64>, Vec<f64>) {
    let turn = DQuat::from_axis_angle(axis, angle);
    let bend = DQuat::from_axis_angle(DVec3::new(0.4, 0.5, -0.7).normalize(), 0.3);
    let (d, v, w) = (DVec3::new(0.37, 0.06, -0.04), DVec3::new(0.2, 0.5, -0.3), DVec3::new(0.3, -0.6, 0.8));
    state([DVec3::ZERO, turn * d], [turn, turn * bend], [DVec3::ZERO, turn * v], [DVec3::ZERO, turn * w])
}

/// Truth: forces and moments of a beam balance, and loads turn with the beam: no jump anywhere in a full
/// turn. The tolerance is the rounding of some ten rotations of the largest load.
#[test]
fn loads_balance_and_turn_with_the_beam_all_the_way_round() {
    for (what, mut system) in all() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 2.0, -0.5).normalize()] {
            let still = loads(&mut system, &deformed(axis, 0.0)).unwrap();
            let size = still.iter().fold(0.0_f64, |m, l| m.max(l.length()));
            assert!(size > 1.0, "{what} does nothing");
            for step in 0..=72 {
                let angle = f64::from(step) * std::f64::consts::TAU / 72.0;
                let at = deformed(axis, angle);
                let turned = loads(&mut system, &at).unwrap();
                let rotation = DMat3::from_axis_angle(axis, angle);
                for (k, (a, b)) in still.iter().zip(turned).enumerate() {
                    // Forces in ground axes, torques in those of the bodies.
                    let expected = if k % 2 == 0 { rotation * *a } else { *a };
                    assert!((expected - b).length() < 1e-12 * size, "{what} {step} {k}: {expected} {b}");
                }
                let turn =
                    |k: usize| DQuat::from_xyzw(at.0[7 * k + 4], at.0[7 * k + 5], at.0[7 * k + 6], at.0[7 * k + 3]);
                let arm = DVec3::from_slice(&at.0[7..]);
                let [f1, t1, f2, t2] = turned;
                let moment = turn(0) * t1 + turn(1) * t2 + arm.cross(f2);
                assert!((f1 + f2).length() < 1e-12 * size && moment.length() < 1e-12 * size, "{what} {step}");
            }
        }
    }
}

/// Truth: small deformations meet the matrix of the help page, whatever the theory: -K q with shear in
/// LINEAR and STRING always, in NONLINEAR on demand. The rest is of second order: 1e-6 of the load.
#[test]
fn small_loads_are_those_of_the_matrix() {
    let (e, g, area, ixx, iyy, izz) = (2.07e11, 8.0e10, 78.5e-6, 981.0e-12, 491.0e-12, 300.0e-12);
    for (formulation, shear) in [("linear", false), ("string", false), ("nonlinear", false), ("nonlinear", true)] {
        let mut system = system(formulation, shear, false, false);
        let sheared = shear || formulation != "nonlinear";
        let correction =
            |i: f64, ratio: f64| if sheared { 12.0 * e * i * ratio / (g * area * LENGTH * LENGTH) } else { 0.0 };
        let (py, pz) = (correction(izz, 1.2), correction(iyy, 1.5));
        let (by, bz) = (e * izz / (LENGTH * (1.0 + py)), e * iyy / (LENGTH * (1.0 + pz)));
        let mut k = [[0.0; 6]; 6];
        k[0][0] = e * area / LENGTH;
        (k[1][1], k[2][2]) = (12.0 * by / LENGTH.powi(2), 12.0 * bz / LENGTH.powi(2));
        (k[1][5], k[5][1], k[2][4], k[4][2]) =
            (-6.0 * by / LENGTH, -6.0 * by / LENGTH, 6.0 * bz / LENGTH, 6.0 * bz / LENGTH);
        (k[3][3], k[4][4], k[5][5]) = (g * ixx / LENGTH, (4.0 + pz) * bz, (4.0 + py) * by);
        for column in 0..6 {
            let small = 1e-7;
            // A chord of a shifted end is longer by d^2 / 2L.
            let second_order = k[0][0] * small * small / LENGTH;
            let step = DVec3::from_array(std::array::from_fn(|i| if i == column % 3 { small } else { 0.0 }));
            let (dx, turn) =
                if column < 3 { (step, DQuat::IDENTITY) } else { (DVec3::ZERO, DQuat::from_scaled_axis(step)) };
            let at = state(
                [DVec3::ZERO, DVec3::new(LENGTH, 0.0, 0.0) + dx],
                [DQuat::IDENTITY, turn],
                [DVec3::ZERO; 2],
                [DVec3::ZERO; 2],
            );
            let [_, _, force, torque] = loads(&mut system, &at).unwrap();
            // The residual is minus the load: what holds the deformation.
            let found = [force.x, force.y, force.z, torque.x, torque.y, torque.z];
            let largest = (0..6).map(|row| (k[row][column] * small).abs()).fold(0.0, f64::max);
            for row in 0..6 {
                let expected = k[row][column] * small;
                assert!(
                    (found[row] - expected).abs() < 2e-6 * largest + second_order,
                    "{formulation} {shear} {row} {column}: {} {expected}",
                    found[row]
                );
            }
        }
    }
}

/// Markers that meet leave STRING and NONLINEAR without direction: an error that names the beam. LINEAR
/// has the axes of J and a finite load.
#[test]
fn markers_that_meet_are_refused_by_name() {
    for (what, mut system) in all() {
        let met = state([DVec3::ZERO; 2], [DQuat::IDENTITY; 2], [DVec3::ZERO; 2], [DVec3::ZERO; 2]);
        let found = loads(&mut system, &met);
        if what.starts_with("linear") {
            assert!(found.unwrap().iter().all(|l| l.is_finite()), "{what}");
        } else {
            let message = found.unwrap_err();
            assert!(message.contains(".m.bar") && message.contains("markers meet"), "{what}: {message}");
        }
    }
}
