//! Forces whose functions ask for the load of a beam: values, the order of creation, what is refused.

mod common;

use common::{Build, codes};
use flexure_elements::{Options, lower};
use model::ObjectId;
use schema::UnitSystem;
use solver::{Dae, JacobianPoint};
use text::Diagnostic;

/// A bar of 500 mm that is 1 mm too long, from ground to a part, and a force on another part.
fn bar_and_force(function: &str) -> (Build, ObjectId) {
    let mut b = Build::new(UnitSystem::mmks());
    let root = b.marker(b.ground, "j", [0.0; 3]);
    let tip = b.part("tip", [501.0, 0.0, 0.0], 2.0, 100.0);
    let i = b.marker(tip, "i", [0.0; 3]);
    let other = b.part("other", [0.0, 900.0, 0.0], 3.0, 100.0);
    let at = b.marker(other, "at", [0.0; 3]);
    let force = b.add("single_component_force", b.model, "force");
    b.refer(force, "i_marker_name", at);
    b.refer(force, "j_marker_name", root);
    b.word(force, "type_of_freedom", "translational");
    b.database.set_value(force, "action_only", model::Value::Flag(true));
    b.function(force, "function", function);
    let beam = b.beam("bar", i, root, 500.0);
    b.set(beam, "damping_ratio", 0.01);
    (b, force)
}

/// Force on the other part along z, N, in the model as it is built; the bar's end recedes at `speed`.
fn force_on_other(b: &Build, speed: f64) -> f64 {
    let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
    let system = &mut lowered.system;
    let (q, mut v) = system.initial_state();
    v[0] = speed;
    let mut r = vec![0.0; v.len()];
    system.residual(0.0, &q, &v, &vec![0.0; v.len()], &[], &mut r).unwrap();
    -r[6 + 2]
}

fn errors(b: &Build) -> Vec<Diagnostic> {
    match lower(&b.database, b.model, Options::default()) {
        Ok(_) => Vec::new(),
        Err(diagnostics) => diagnostics.into_iter().filter(Diagnostic::is_error).collect(),
    }
}

/// Truth: EA/L = 2.07e5 * 78.5 / 500 N/mm times 1 mm pulls I back, and the damping ratio of 0.01 s adds
/// that of 10 mm/s; half of it acts along z of the J marker. Rounding of products is the tolerance.
#[test]
fn the_load_of_a_beam_can_drive_a_force() {
    let (b, _) = bar_and_force("-0.5*BEAM(.m.bar, 0, 2, .m.ground.j)");
    let stiffness = 2.07e5 * 78.5 / 500.0;
    let still = 0.5 * stiffness;
    assert!((force_on_other(&b, 0.0) - still).abs() < 1e-10 * still);
    let moving = 0.5 * stiffness * (1.0 + 0.01 * 10.0);
    assert!((force_on_other(&b, 0.01) - moving).abs() < 1e-10 * moving);
}

/// Twin: central differences of the residual. The force acts on one part and depends on another one, to
/// which nothing else ties it; that block is in the pattern. Differences of 1e-6 leave 1e-9 of the largest.
#[test]
fn the_derivative_reaches_the_part_that_the_function_looks_at() {
    let (b, _) = bar_and_force("BEAM(.m.bar, 0, 2, .m.tip.cm) + 0.01*BEAM(.m.bar, 1, 8)");
    let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
    let system = &mut lowered.system;
    let (q, _) = system.initial_state();
    let n = system.velocities();
    let (v, zero): (Vec<f64>, Vec<f64>) = ((0..n).map(|k| 0.01 * k as f64).collect(), vec![0.0; n]);
    let pattern = system.pattern();
    assert!(pattern.pairs.contains(&(1, 0)), "{:?}", pattern.pairs);
    for (damping, stiffness) in [(0.0, 1.0), (1.0, 0.0)] {
        let at = JacobianPoint { t: 0.0, q: &q, v: &v, a: &zero, lambda: &[], mass: 0.0, damping, stiffness };
        let mut block = [[0.0; 6]; 6];
        let mut add = |row: usize, column: usize, values: &[f64]| {
            if (row, column) == (1, 0) {
                values.iter().enumerate().for_each(|(k, value)| block[k % 6][k / 6] += value);
            }
        };
        system.jacobian(at, &mut add).unwrap();
        let largest = block.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!(largest > 0.0);
        for column in 0..6 {
            let mut side = |h: f64| {
                let (mut q1, mut v1, mut r) = (q.clone(), v.clone(), zero.clone());
                let mut step = zero.clone();
                step[column] = h * stiffness;
                system.retract(&q, &step, &mut q1);
                v1[column] += h * damping;
                system.residual(0.0, &q1, &v1, &zero, &[], &mut r).unwrap();
                r
            };
            let (plus, minus) = (side(1e-6), side(-1e-6));
            for (row, values) in block.iter().enumerate() {
                let difference = (plus[6 + row] - minus[6 + row]) / 2e-6;
                assert!(
                    (values[column] - difference).abs() < 1e-7 * largest,
                    "{row} {column}: {values:?} {difference}"
                );
            }
        }
    }
}

/// A deactivated element has no load.
#[test]
fn the_load_of_a_deactivated_beam_is_zero() {
    let (mut b, _) = bar_and_force("3 + BEAM(.m.bar, 0, 2)");
    let bar = b.database.find(".m.bar", "beam").unwrap();
    b.word(bar, "active", "off");
    assert!((force_on_other(&b, 0.0) - 3.0).abs() < 1e-12);
}

#[test]
fn a_force_of_its_own_load_is_an_algebraic_loop() {
    let (b, _) = bar_and_force("0.5*SFORCE(.m.force, 0, 2) + SFORCE(.m.force, 0, 3)");
    let found = errors(&b);
    assert_eq!(codes(&found), ["function/algebraic-loop"]);
    assert_eq!(found[0].message, "the function of `.m.force` asks for the load of `.m.force`: an algebraic loop");
}

#[test]
fn a_loop_through_another_force_is_named_with_its_way() {
    let (mut b, force) = bar_and_force("SFORCE(.m.second, 0, 2)");
    let second = b.add("single_component_force", b.model, "second");
    for cell in ["i_marker_name", "j_marker_name"] {
        let marker = b.database.reference(force, cell).unwrap();
        b.refer(second, cell, marker);
    }
    b.function(second, "function", "2*SFORCE(.m.force, 0, 2)");
    let found = errors(&b);
    assert_eq!(codes(&found), ["function/algebraic-loop", "function/algebraic-loop"]);
    assert_eq!(found[0].notes, ["`.m.force`, `.m.second`, `.m.force` asks for the load of the next"]);
}

#[test]
fn loads_that_follow_from_the_solution_are_refused_by_name() {
    let (mut b, _) = bar_and_force("JOINT(.m.hinge, 0, 2)");
    let markers = [".m.other.cm", ".m.ground.j"].map(|name| b.database.find(name, "marker").unwrap());
    b.joint("joint_revolute", "hinge", markers[0], markers[1]);
    let found = errors(&b);
    assert_eq!(codes(&found), ["function/not-of-state"]);
    assert!(found[0].message.contains("`.m.force`") && found[0].message.contains("`.m.hinge`"), "{found:?}");
}

#[test]
fn accelerations_are_refused_in_a_force() {
    let (b, _) = bar_and_force("ACCX(.m.tip.i)");
    assert_eq!(codes(&errors(&b)), ["function/not-of-state"]);
}

#[test]
fn the_function_of_one_class_does_not_ask_for_another() {
    let (b, _) = bar_and_force("BUSH(.m.bar, 0, 2)");
    let found = errors(&b);
    assert_eq!(codes(&found), ["function/unknown-object"]);
    assert!(found[0].message.contains("`.m.bar` is a beam, which BUSH does not ask for"), "{found:?}");
}

/// Motions follow time alone, as their derivatives enter the equations.
#[test]
fn a_motion_that_asks_for_a_load_is_refused() {
    let (mut b, _) = bar_and_force("0");
    let markers = [".m.other.cm", ".m.ground.j"].map(|name| b.database.find(name, "marker").unwrap());
    let joint = b.joint("joint_translational", "slide", markers[0], markers[1]);
    let motion = b.add("motion", b.model, "drive");
    b.refer(motion, "joint_name", joint);
    b.word(motion, "type_of_freedom", "translational");
    b.function(motion, "function", "BEAM(.m.bar, 0, 2)");
    let found = errors(&b);
    assert_eq!(codes(&found), ["motion/state"]);
}
