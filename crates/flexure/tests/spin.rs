//! Modes about a steady spin through commands, what stands in its way, and what is named as left out.

use flexure::{ModesAbout, Session};

/// A blade hinged at 0.3 m on a hub that is driven about z at 7 rad/s: 2 kg at 0.5 m from the hinge.
const ROTOR: &str = "\
defaults units length=meter angle=rad force=newton mass=kg time=second
model create model_name=m
marker create marker_name=.m.ground.axis location=0,0,0
marker create marker_name=.m.ground.aside location=0,0,0 orientation=0,1.5707963267948966,0
part create rigid_body name_and_position part_name=.m.hub location=0,0,0
marker create marker_name=.m.hub.axis location=0,0,0
marker create marker_name=.m.hub.hinge location=0.3,0,0
part create rigid_body mass_properties part_name=.m.hub mass=1 center_of_mass_marker=.m.hub.axis ixx=1 iyy=1 izz=1
part create rigid_body name_and_position part_name=.m.blade location=0.8,0,0
marker create marker_name=.m.blade.cm location=0.8,0,0
marker create marker_name=.m.blade.hinge location=0.3,0,0
part create rigid_body mass_properties part_name=.m.blade mass=2 center_of_mass_marker=.m.blade.cm ixx=0.001 iyy=0.04 izz=0.04
constraint create joint revolute joint_name=.m.turn i_marker_name=.m.hub.axis j_marker_name=.m.ground.axis
constraint create joint revolute joint_name=.m.lag i_marker_name=.m.blade.hinge j_marker_name=.m.hub.hinge
constraint create motion_generator motion_name=.m.drive joint_name=.m.turn type_of_freedom=rotational time_derivative=displacement function=\"7*time\"
";

fn session(more: &str) -> Session {
    let mut session = Session::new();
    let report = session.execute(&format!("{ROTOR}{more}"));
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    session
}

fn about(marker: &str, rate: f64) -> ModesAbout {
    ModesAbout::Spin { marker: marker.into(), rate }
}

/// Truth: a rigid blade hinged at e from the axis lags with W sqrt(m l e / I), I about the hinge
/// (W. Johnson, Helicopter Theory, ch. 9); the tolerance is that of the statics' default error.
#[test]
fn a_hinged_blade_lags_as_theory_says() {
    let found = session("").modes(&about(".m.ground.axis", 7.0)).unwrap().modes;
    let wanted = 7.0 * (2.0_f64 * 0.5 * 0.3 / (0.04 + 2.0 * 0.5 * 0.5)).sqrt();
    assert_eq!(found.len(), 1);
    assert!((found[0].imaginary / wanted - 1.0).abs() < 1e-6, "{} {wanted}", found[0].imaginary);
}

/// Truth: flap of a rotating cantilever at 8 times sqrt(EI / rho A L^4) is 9.2568 of that unit (Wright and
/// others, 1982); 24 beams are within 1e-3 of the continuum. On this chain the eigenvalue iteration goes
/// round in circles with the first shift it tries.
#[test]
fn another_shift_finds_modes_that_the_first_does_not() {
    let mut session = Session::new();
    let beams = concat!(env!("CARGO_MANIFEST_DIR"), "/../../mechanisms/beams/beams.cmd");
    assert_eq!(session.read(beams.as_ref()).failed, 0);
    let chain = "chain n=24 formulation=nonlinear ea=1e6 rotary_y=1e-10 rotary_z=1e-10 polar=1e-10 turn=\"8.0*time\"";
    assert_eq!(session.execute(chain).failed, 0);
    let found = session.modes(&about(".chain.ground.node_0", 8.0)).unwrap().modes;
    assert!((found[1].imaginary / 9.2568 - 1.0).abs() < 1e-3, "{}", found[1].imaginary);
}

#[test]
fn what_cannot_spin_steadily_is_refused_by_name() {
    let gravity = "force create body gravitational gravity_field_name=.m.g x_component_gravity=0 y_component_gravity=-9.8 z_component_gravity=0\n";
    let cases = [
        ("", about("nowhere", 7.0), "modes/no-axis", "nowhere"),
        ("", about(".m.ground.axis", 5.0), "modes/held", ".m.drive"),
        ("", about(".m.ground.aside", 7.0), "modes/held", ".m."),
        (gravity, about(".m.ground.axis", 7.0), "modes/gravity-turns", "gravity"),
    ];
    for (more, about, code, named) in cases {
        let found = session(more).modes(&about).unwrap_err();
        assert_eq!(found[0].code, code, "{found:?}");
        assert!(found[0].message.contains(named), "{found:?}");
        assert!(!found[0].helps.is_empty());
    }
}

#[test]
fn measures_that_are_not_computed_are_named() {
    let measures = "\
measure create angle measure_name=.m.bent first_point=.m.blade.cm middle_point=.m.hub.hinge last_point=.m.hub.axis
measure create point measure_name=.m.moved point=.m.blade.cm characteristic=sum_of_forces_at_marker component=x_component
";
    let found = session(measures).modes(&ModesAbout::Present).unwrap().diagnostics;
    for name in [".m.bent", ".m.moved"] {
        let named = found.iter().any(|d| d.code == "measure/not-recorded" && d.message.contains(name));
        assert!(named, "{name}: {found:?}");
    }
}
