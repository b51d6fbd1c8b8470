//! The lowest modes by iteration against the twin that finds all modes at once, where joints leave
//! fewer free motions than there are iterated vectors.

use std::fmt::Write;

use flexure::Session;
use solver::{Look, LowestModes, ModeOptions, SystemState, initial, modes};

/// Two bodies and a beam on each; joints decide how many motions are left.
fn model(first: &str, second: &str) -> String {
    let mut text = String::from(
        "model create model_name=m\n\
         defaults units length=meter force=newton mass=kg time=sec angle=deg\n\
         marker create marker_name=.m.ground.j location=0,0,0 orientation=0,0,0\n\
         marker create marker_name=.m.ground.k location=5,0,0 orientation=0,0,0\n",
    );
    for (name, x, inertia, joint) in [("a", 1.1, "1,2,3", first), ("b", 5.7, "0.4,0.1,0.2", second)] {
        let [ixx, iyy, izz] = inertia.split(',').collect::<Vec<_>>().try_into().unwrap();
        let (ground, back) = if name == "a" { ("j", 1.1) } else { ("k", 0.7) };
        let _ = writeln!(
            text,
            "part create rigid_body name_and_position part_name=.m.{name} location={x},0,0 orientation=0,0,0\n\
             marker create marker_name=.m.{name}.cm location=0,0,0 orientation=0,0,0 relative_to=.m.{name}\n\
             marker create marker_name=.m.{name}.o location=-{back},0,0 orientation=0,0,0 relative_to=.m.{name}\n\
             part create rigid_body mass_properties part_name=.m.{name} mass=1 center_of_mass_marker=.m.{name}.cm \
             ixx={ixx} iyy={iyy} izz={izz}\n\
             force create element_like beam beam_name=.m.beam_{name} i_marker_name=.m.{name}.cm \
             j_marker_name=.m.ground.{ground} length={back} area_of_cross_section=1.2e-4 youngs_modulus=2e9 \
             shear_modulus=8e8 ixx=2e-8 iyy=1.1e-8 izz=1.3e-8"
        );
        if !joint.is_empty() {
            let _ = writeln!(
                text,
                "constraint create {joint}_name=.m.joint_{name} i_marker_name=.m.{name}.o \
                 j_marker_name=.m.ground.{ground}"
            );
        }
    }
    text
}

/// Twin: the dense eigenvalues. The iteration ends at changes of 1e-9 of the lowest elastic frequency.
#[test]
fn joints_that_leave_few_motions_do_not_lead_astray() {
    let revolute = "joint revolute joint";
    let (fixed, spherical, cylindrical) = ("joint fixed joint", "joint spherical joint", "joint cylindrical joint");
    let (inline, inplane) = ("primitive_joint inline jprim", "primitive_joint inplane jprim");
    let cases = [
        (1, revolute, fixed),
        (2, revolute, revolute),
        (3, spherical, fixed),
        (4, spherical, revolute),
        (5, spherical, cylindrical),
        (6, "", fixed),
        (7, "", revolute),
        (8, "", cylindrical),
        (9, "", spherical),
        (10, "", inline),
        (11, "", inplane),
        (12, "", ""),
    ];
    for (freedom, first, second) in cases {
        let mut session = Session::new();
        let report = session.execute(&model(first, second));
        assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
        let options = elements::Options::default();
        let mut system = elements::lower(session.database(), session.model().unwrap(), options).unwrap().system;
        let (q, v) = system.initial_state();
        let mut state = SystemState { t: 0.0, q, v, ..SystemState::default() };
        initial::accelerations(&mut system, &mut state).unwrap();
        let dense = modes(&mut system, &state, &ModeOptions::default()).unwrap();
        assert_eq!(dense.freedoms, freedom);
        let found = LowestModes::new(&mut system, &state).unwrap().find(12, |_| Look::Wanted).unwrap().modes;
        let expected: Vec<f64> = dense.modes.iter().map(|m| m.undamped_frequency() * std::f64::consts::TAU).collect();
        let shown: Vec<f64> = found.iter().map(|m| m.frequency).collect();
        assert_eq!(found.len(), freedom, "{expected:?} {shown:?}");
        for (mode, w) in found.iter().zip(expected) {
            assert!((mode.frequency / w - 1.0).abs() < 1e-6, "{freedom}: {} {w}", mode.frequency);
        }
    }
}
