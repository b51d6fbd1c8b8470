//! Steady spins: what is at rest in turning axes, and how it swings there.

extern crate flexure_equations as equations;

mod common;

use equations::constraints::{Drive, Driven, Pair};
use equations::{Body, BodyId, Constraint, Frame, FrameId, GROUND, Spin, System};
use glam::{DMat3, DQuat, DVec3};
use solver::{ModeOptions, Silent, StaticOptions, SystemState, equilibrium, initial, modes};

const SPIN: f64 = 7.0;
/// Distance of the hinge from the axis, and of the blade's centre from the hinge.
const HUB: f64 = 0.3;
const ARM: f64 = 0.5;
const MASS: f64 = 2.0;
/// About the centre, across the blade.
const MOMENT: f64 = 0.04;

fn frame(name: &str, body: BodyId, r_bi_b: DVec3, rot_bi: DMat3) -> Frame {
    Frame { name: name.into(), body, r_bi_b, rot_bi }
}

fn body(name: &str, at: DVec3, inertia: DVec3) -> Body {
    let mut body = common::body(name, &mut common::Random(1), false);
    (body.mass, body.inertia_c_b) = (MASS, DMat3::from_diagonal(inertia));
    body.initial = common::motion(at, DQuat::IDENTITY, DVec3::ZERO, DVec3::ZERO);
    body
}

/// A thin blade on a hub that turns about z with a rate of its own; the hinge's axis is across the
/// blade: z to swing in the plane of rotation, y to flap out of it.
fn rotor(hinge: DMat3, rate: f64, start: f64) -> System {
    let tilted = DQuat::from_mat3(&(hinge * DMat3::from_rotation_z(start) * hinge.transpose()));
    let mut blade = body(".m.blade", DVec3::X * HUB + tilted * (DVec3::X * ARM), DVec3::new(1e-9, MOMENT, MOMENT));
    blade.initial.q_gb = tilted;
    let hub = body(".m.hub", DVec3::ZERO, DVec3::ONE);
    let frames = vec![
        frame(".m.hub.axis", BodyId(0), DVec3::ZERO, DMat3::IDENTITY),
        frame(".m.ground.axis", GROUND, DVec3::ZERO, DMat3::IDENTITY),
        frame(".m.blade.hinge", BodyId(1), DVec3::X * -ARM, hinge),
        frame(".m.hub.hinge", BodyId(0), DVec3::X * HUB, hinge),
    ];
    let [axis, base, outer, inner] = [0, 1, 2, 3].map(FrameId);
    let joint = |i, j| -> Box<dyn Constraint> { Box::new(Pair::revolute(".m.joint".into(), &frames, i, j)) };
    let function = Box::new(move |t: f64| [rate * t, rate, 0.0]);
    let motion = Driven::new(".m.motion".into(), &frames, axis, base, Drive::Rotation, function);
    let joints: Vec<Box<dyn Constraint>> = vec![joint(axis, base), joint(outer, inner), Box::new(motion)];
    System::new(vec![hub, blade], frames, Vec::new(), joints, DVec3::ZERO).unwrap()
}

/// Frequency of the only mode about the steady spin that the search finds from a start off balance.
fn swing(hinge: DMat3) -> f64 {
    let mut system = rotor(hinge, SPIN, 0.4);
    let (q, _) = system.initial_state();
    let mut spin = Spin::new(&mut system, DVec3::ZERO, DVec3::Z * SPIN);
    let mut state = SystemState::at_rest(&spin, 0.0, q);
    let options = StaticOptions { error: 1e-10, imbalance: 1e-9, ..StaticOptions::default() };
    equilibrium(&mut spin, &mut state, &options, &mut Silent).unwrap();
    initial::accelerations(&mut spin, &mut state).unwrap();
    assert!(state.a.iter().all(|a| a.abs() < 1e-6), "{:?}", state.a);
    // The blade points outward.
    assert!((state.q[7] - HUB - ARM).abs() < 1e-9 && state.q[8].abs() + state.q[9].abs() < 1e-8, "{:?}", state.q);
    let found = modes(&mut spin, &state, &ModeOptions::default()).unwrap();
    assert_eq!(found.modes.len(), 1);
    assert!(found.modes[0].eigenvalue[0].abs() < 1e-9 * SPIN);
    found.modes[0].eigenvalue[1]
}

/// Truth: a rigid blade hinged at a distance e from the axis, with the moment I about its hinge and
/// the centre at l: in the plane w^2 = W^2 m l e / I, out of it w^2 = W^2 (1 + m l e / I), less the
/// moment about the blade's own axis, which is 1e-9 of I here. (W. Johnson, Helicopter Theory, ch. 9.)
#[test]
fn a_hinged_blade_swings_with_its_centrifugal_stiffness() {
    let about_hinge = MOMENT + MASS * ARM * ARM;
    let pull = MASS * ARM * HUB / about_hinge;
    let lag = swing(DMat3::IDENTITY);
    assert!((lag / (SPIN * pull.sqrt()) - 1.0).abs() < 1e-7, "{lag}");
    let flap = swing(DMat3::from_cols(DVec3::X, -DVec3::Z, DVec3::Y));
    assert!((flap / (SPIN * (1.0 + pull).sqrt()) - 1.0).abs() < 1e-7, "{flap}");
}

/// Truth: a motion that turns at another rate than the whole is broken by the difference.
#[test]
fn what_does_not_turn_with_the_whole_is_named() {
    for (rate, difference) in [(SPIN, None), (5.0, Some(SPIN - 5.0))] {
        let mut system = rotor(DMat3::IDENTITY, rate, 0.0);
        let (q, _) = system.initial_state();
        let broken = Spin::new(&mut system, DVec3::ZERO, DVec3::Z * SPIN).broken_equation(0.0, &q).unwrap();
        assert_eq!(broken.is_some(), difference.is_some(), "{broken:?}");
        if let (Some((name, found)), Some(wanted)) = (broken, difference) {
            assert!(name.starts_with(".m.motion"), "{name}");
            assert!((found.abs() - wanted).abs() < 1e-12);
        }
    }
}
