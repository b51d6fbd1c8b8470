//! Models become equations: units, frames, masses, velocities, what is refused and what is said.

mod common;

use common::{Build, codes};
use flexure_elements::{Options, lower};
use schema::UnitSystem;
use solver::Dae;
use text::Diagnostic;

fn errors(build: &Build) -> Vec<Diagnostic> {
    match lower(&build.database, build.model, Options::default()) {
        Ok(_) => Vec::new(),
        Err(diagnostics) => diagnostics.into_iter().filter(Diagnostic::is_error).collect(),
    }
}

/// What acts and has no physics is refused by name, unless it is switched off: nobody shall take the
/// result of another model for that of this one.
#[test]
fn what_acts_but_cannot_be_simulated_refuses_the_run() {
    for class in ["field", "friction", "general_force", "contact", "coupler", "joint_screw", "differential_equation"] {
        let mut b = cantilever();
        let object = b.add(class, b.model, "extra");
        let found = errors(&b);
        assert_eq!(codes(&found), ["element/not-simulated"], "{class}");
        assert!(found[0].message.contains("`.m.extra`"), "{}", found[0].message);
        assert!(found[0].helps.iter().any(|h| h.text.contains("entity_name = .m.extra active = off")), "{found:?}");
        if b.database.object(object).class.cell_index("active").is_some() {
            b.word(object, "active", "off");
            assert!(errors(&b).is_empty(), "{class}");
        }
    }
}

/// A number that is none is named, and so are numbers that are missing.
#[test]
fn springs_without_usable_numbers_are_refused() {
    let mut b = cantilever();
    let (i, j) = (b.database.find(".m.tip.i", "marker").unwrap(), b.database.find(".m.ground.root", "marker").unwrap());
    let bushing = b.joint("bushing", "mount", i, j);
    assert!(errors(&b).is_empty());
    b.numbers(bushing, "stiffness", &[1.0, 2.0]);
    b.numbers(bushing, "tdamping", &[1.0, f64::NAN, 2.0]);
    let found = errors(&b);
    assert_eq!(codes(&found), ["force/not-a-number"; 2]);
    assert!(found[0].message.contains("`stiffness` of bushing `.m.mount` is not 3 finite numbers"), "{found:?}");
    let spring = b.add("translational_spring_damper", b.model, "spring");
    b.refer(spring, "i_marker_name", i);
    assert!(codes(&errors(&b)).contains(&"force/no-marker"));
}

/// One beam from ground to a part, 500 mm along x.
fn cantilever() -> Build {
    let mut b = Build::new(UnitSystem::mmks());
    let root = b.marker(b.ground, "root", [0.0; 3]);
    let tip = b.part("tip", [500.0, 0.0, 0.0], 2.0, 100.0);
    let i = b.marker(tip, "i", [0.0; 3]);
    b.beam("bar", i, root, 500.0);
    b.gravity([0.0, -9806.65, 0.0]);
    b
}

/// Truth: mm, MPa and mm^4 in SI by hand: EA/L = 2.07e11 * 78.5e-6 / 0.5 N/m.
#[test]
fn a_beam_and_a_part_are_lowered_in_si() {
    let b = cantilever();
    let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
    assert_eq!(codes(&lowered.diagnostics), ["output/everything"]);
    let system = &mut lowered.system;
    assert_eq!((system.velocities(), Dae::constraints(system)), (6, 0));
    let body = &system.bodies()[0];
    assert_eq!(body.mass, 2.0);
    assert!((body.inertia_c_b.x_axis.x - 100e-6).abs() < 1e-18);
    assert_eq!(body.initial.r_gb_g.to_array(), [0.5, 0.0, 0.0]);
    assert!((system.gravity_g().y + 9.80665).abs() < 1e-14);

    // Pulled by 1 mm the bar pulls back with EA/L * 1 mm.
    let (q, v) = system.initial_state();
    let mut moved = q.clone();
    moved[0] += 1e-3;
    let mut r = vec![0.0_f64; 6];
    system.residual(0.0, &moved, &v, &[0.0; 6], &[], &mut r).unwrap();
    let pull = 2.07e11 * 78.5e-6 / 0.5 * 1e-3;
    assert!((r[0] - pull).abs() < 1e-9 * pull, "{} is not {pull}", r[0]);
    // Undeformed, only the weight is left.
    system.residual(0.0, &q, &v, &[0.0; 6], &[], &mut r).unwrap();
    assert!((r[1] - 2.0 * 9.80665).abs() < 1e-12 && r[0].abs() < 1e-6);
}

/// Truth: the part is turned 90 degrees about z, so global x is -y of the part. A plain number is in
/// radians per unit of time although angles are in degrees; with a marker, along its axes.
#[test]
fn start_angular_velocities_are_global_and_in_radians_per_time() {
    let mut b = cantilever();
    let units = UnitSystem::named("mm", "kg", "millisecond", "newton", "degrees").unwrap();
    b.database.set_units(units);
    let tip = b.database.find(".m.tip", "part").unwrap();
    b.numbers(tip, "orientation", &[90.0, 0.0, 0.0]);
    b.set(tip, "wx", 0.002);
    let spin = |b: &Build| {
        let lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
        lowered.system.bodies()[0].initial.w_gb_b
    };
    // Tolerance: rounding of the turn by 90 degrees.
    assert!((spin(&b) - glam::DVec3::new(0.0, -2.0, 0.0)).length() < 1e-14, "{}", spin(&b));
    let i = b.database.find(".m.tip.i", "marker").unwrap();
    b.refer(tip, "wm", i);
    assert!((spin(&b) - glam::DVec3::new(2.0, 0.0, 0.0)).length() < 1e-14, "{}", spin(&b));
}

/// Truth: damping terms are in newton, mm, s and radians: C11 per velocity, C41 per velocity as a
/// torque, C44 as torque per angular velocity.
#[test]
fn damping_terms_are_converted() {
    let mut b = cantilever();
    let beam = b.database.find(".m.bar", "beam").unwrap();
    let mut terms = [0.0; 21];
    (terms[0], terms[3], terms[15]) = (2.0, 3.0, 5.0);
    b.numbers(beam, "matrix_of_damping_terms", &terms);
    let mut lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
    let system = &mut lowered.system;
    let (q, _) = system.initial_state();
    let mut r = vec![0.0_f64; 6];
    system.residual(0.0, &q, &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], &[0.0; 6], &[], &mut r).unwrap();
    // 2 N s/mm = 2000 N s/m; 3 N mm s/mm = 3 N m s/m.
    assert!((r[0] - 2000.0).abs() < 1e-9 && (r[3] - 3.0).abs() < 1e-12, "{r:?}");
    system.residual(0.0, &q, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], &[0.0; 6], &[], &mut r).unwrap();
    // 3 N s per rad; 5 N mm s/rad = 0.005 N m s/rad.
    assert!((r[0] - 3.0).abs() < 1e-12 && (r[3] - 0.005).abs() < 1e-15, "{r:?}");
}

/// Truth: parallel axes and Adams' positive products of inertia, by hand: a mass of 2 kg at
/// (10, 20, 0) mm from the inertia marker has Ixy = -m x y off the diagonal there.
#[test]
fn inertia_is_moved_to_the_centre_of_mass() {
    let mut b = Build::new(UnitSystem::mmks());
    let part = b.part("p", [0.0; 3], 2.0, 0.0);
    let cm = b.database.find(".m.p.cm", "marker").unwrap();
    b.numbers(cm, "location", &[10.0, 20.0, 0.0]);
    let im = b.marker(part, "im", [0.0; 3]);
    b.refer(part, "inertia_marker", im);
    // About the origin: 2*(20^2), 2*(10^2), 2*(500) plus 7 on each axis; product 2*10*20.
    for (cell, value) in [("ixx", 807.0), ("iyy", 207.0), ("izz", 1007.0), ("ixy", 400.0)] {
        b.set(part, cell, value);
    }
    let lowered = lower(&b.database, b.model, Options::default()).unwrap_or_else(|d| panic!("{d:?}"));
    let body = &lowered.system.bodies()[0];
    assert!((body.initial.r_gb_g - glam::DVec3::new(0.01, 0.02, 0.0)).length() < 1e-15);
    let expected = glam::DMat3::from_diagonal(glam::DVec3::splat(7e-6));
    assert!(body.inertia_c_b.abs_diff_eq(expected, 1e-15), "{:?}", body.inertia_c_b);
}

/// Truth: a velocity in global axes stays; along `vm` it turns with that marker; angular velocity
/// is in radians per second.
#[test]
fn start_velocities_are_read_along_their_markers() {
    let mut b = Build::new(UnitSystem::mmks());
    let part = b.part("p", [0.0; 3], 1.0, 1.0);
    b.numbers(part, "orientation", &[90.0, 0.0, 0.0]);
    b.set(part, "vx", 1000.0);
    b.set(part, "wz", std::f64::consts::PI);
    let start = |b: &Build| lower(&b.database, b.model, Options::default()).ok().unwrap().system.bodies()[0].initial;
    let plain = start(&b);
    assert!((plain.v_gb_g - glam::DVec3::X).length() < 1e-15);
    assert!((plain.w_gb_b - glam::DVec3::Z * std::f64::consts::PI).length() < 1e-14);
    let vm = b.marker(part, "vm", [0.0; 3]);
    b.refer(part, "vm", vm);
    assert!((start(&b).v_gb_g - glam::DVec3::Y).length() < 1e-15);
}

#[test]
fn bad_beam_data_is_refused_by_name() {
    let mut b = cantilever();
    let beam = b.database.find(".m.bar", "beam").unwrap();
    for (cell, value, code) in [
        ("length", 0.0, "beam/not-positive"),
        ("length", f64::INFINITY, "beam/not-a-number"),
        ("youngs_modulus", -1.0, "beam/not-positive"),
        ("iyy", -1.0, "beam/negative"),
        ("damping_ratio", -1.0, "beam/negative"),
    ] {
        let before = b.database.number(beam, cell).unwrap();
        b.set(beam, cell, value);
        let found = errors(&b);
        assert_eq!(codes(&found), [code], "{cell}");
        assert!(found[0].message.contains(".m.bar") && found[0].message.contains(cell), "{}", found[0].message);
        assert!(!found[0].helps.is_empty());
        b.set(beam, cell, before);
    }
    b.numbers(beam, "matrix_of_damping_terms", &[1.0; 20]);
    let found = errors(&b);
    assert_eq!(codes(&found), ["beam/damping-terms"]);
    assert!(found[0].message.contains("20") && found[0].message.contains("21"));
}

#[test]
fn every_formulation_of_the_table_is_simulated() {
    let mut b = cantilever();
    let beam = b.database.find(".m.bar", "beam").unwrap();
    for word in ["linear", "string", "nonlinear"] {
        b.word(beam, "formulation", word);
        assert!(errors(&b).is_empty(), "{word}");
    }
}

#[test]
fn what_is_inactive_is_left_out() {
    let mut b = cantilever();
    let beam = b.database.find(".m.bar", "beam").unwrap();
    b.word(beam, "active", "off");
    let lowered = lower(&b.database, b.model, Options::default()).ok().unwrap();
    assert!(lowered.system.force_list().is_empty());
    b.word(beam, "active", "on");
    let tip = b.database.find(".m.tip", "part").unwrap();
    b.word(tip, "active", "off");
    assert_eq!(codes(&errors(&b)), ["marker/no-part"]);
}

/// Truth: with the factor twice what follows from the units, masses act half: F * UCF = m a.
#[test]
fn a_units_consistency_factor_scales_masses() {
    let mut units = UnitSystem::mmks();
    units.consistency_factor = Some(2000.0);
    let mut b = Build::new(units);
    b.part("p", [0.0; 3], 3.0, 1.0);
    let lowered = lower(&b.database, b.model, Options::default()).ok().unwrap();
    assert_eq!(lowered.system.bodies()[0].mass, 1.5);
    assert!(codes(&lowered.diagnostics).contains(&"units/consistency-factor"));
}
