//! What a run records: names, units, values in model units, angles that count turns.

mod common;

use common::{Build, codes};
use flexure_elements::{Lowered, Options, lower};
use model::{ObjectId, Value};
use schema::UnitSystem;
use solver::Dae;

fn lowered(b: &Build, options: Options) -> Lowered {
    lower(&b.database, b.model, options).unwrap_or_else(|d| panic!("{d:?}"))
}

/// A wheel that turns about z of ground at 50 mm.
fn wheel() -> (Build, ObjectId) {
    let mut b = Build::new(UnitSystem::mmks());
    let part = b.part("wheel", [50.0, 0.0, 0.0], 2.0, 100.0);
    let (i, j) = (b.marker(part, "i", [0.0; 3]), b.marker(b.ground, "j", [50.0, 0.0, 0.0]));
    let joint = b.joint("joint_revolute", "pin", i, j);
    (b, joint)
}

fn names(l: &Lowered) -> Vec<(String, String)> {
    l.outputs.columns()
}

fn row(l: &mut Lowered, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
    let mut row = vec![f64::NAN; l.outputs.len()];
    let lambda = vec![0.0; Dae::constraints(&l.system)];
    let a = vec![0.0; v.len()];
    l.outputs.evaluate(&mut l.system, t, q, v, &a, &lambda, &mut row);
    row
}

fn column(l: &Lowered, name: &str) -> usize {
    names(l).iter().position(|c| c.0 == name).unwrap_or_else(|| panic!("no {name} in {:?}", names(l)))
}

#[test]
fn without_requests_everything_is_recorded() {
    let (b, _) = wheel();
    let l = lowered(&b, Options::default());
    assert_eq!(codes(&l.diagnostics), ["output/everything"]);
    let all = names(&l);
    assert_eq!(all[0], ("time".into(), "second".into()));
    assert_eq!(all[1], ("wheel_XFORM.X".into(), "mm".into()));
    assert_eq!(all[4], ("wheel_XFORM.PSI".into(), "degrees".into()));
    assert_eq!(all[7], ("wheel_XFORM.VX".into(), "mm/second".into()));
    assert_eq!(all.last().unwrap().0, "pin.TZ");
    assert_eq!(all.len(), 1 + 18 + 6);
}

/// Truth: 0.05 m is 50 mm; a wheel at 10 rad/s has turned by 20 rad after 2 s, more than three
/// turns, although it is looked at only every 0.25 s and 2.5 rad.
#[test]
fn requests_are_in_model_units_and_count_turns() {
    let (mut b, _) = wheel();
    let request = b.add("request", b.model, "REQ");
    b.word(request, "output_type", "displacement");
    let cm = b.database.find(".m.wheel.cm", "marker").unwrap();
    b.refer(request, "i_marker_name", cm);
    let functions = b.add("request", b.model, "FUN");
    b.function(functions, "f2", "AZ(.m.wheel.cm)*RTOD");
    b.function(functions, "f3", "2*TIME+DX(.m.wheel.cm)");
    b.database.set_value(functions, "component_names", Value::Texts(vec![String::new(), "turn".into()]));
    let mut l = lowered(&b, Options::default());
    let all: Vec<_> = names(&l).into_iter().map(|c| c.0).collect();
    let expected =
        ["time", "REQ.X", "REQ.Y", "REQ.Z", "REQ.MAG", "REQ.R1", "REQ.R2", "REQ.R3", "REQ.RMAG", "FUN.turn", "FUN.F3"];
    assert_eq!(all, expected);
    let (q0, mut v) = l.system.initial_state();
    v[5] = 10.0;
    for step in 0..=8 {
        let t = 0.25 * f64::from(step);
        let (mut q, angle) = (q0.clone(), 10.0 * t);
        (q[3], q[6]) = ((angle / 2.0).cos(), (angle / 2.0).sin());
        let row = row(&mut l, t, &q, &v);
        let value = |name: &str| row[column(&l, name)];
        assert!((value("REQ.X") - 50.0).abs() < 1e-12 && (value("REQ.MAG") - 50.0).abs() < 1e-12);
        assert!((value("FUN.turn") - angle.to_degrees()).abs() < 1e-9, "{} at {t}", value("FUN.turn"));
        assert!((value("FUN.F3") - (2.0 * t + 50.0)).abs() < 1e-12);
        assert!((value("REQ.RMAG").to_radians() - (angle.cos()).acos()).abs() < 1e-7);
    }
}

/// Truth: a bar 1 mm too long, at 500 mm, bent by nothing else and drawn out at 20 mm/s: tension EA/L times
/// 1 mm and damping of 1E-3 s; energy EA/L (1 mm)^2 / 2, power 1E-3 s EA/L (20 mm/s)^2. Rounding.
#[test]
fn what_goes_through_a_beam_is_recorded_with_its_units() {
    let mut b = Build::new(UnitSystem::mmks());
    let j = b.marker(b.ground, "j", [0.0; 3]);
    let part = b.part("tip", [501.0, 0.0, 0.0], 2.0, 100.0);
    let i = b.marker(part, "i", [0.0; 3]);
    b.beam("bar", i, j, 500.0);
    let mut l = lowered(&b, Options { record_beams: true, ..Options::default() });
    let (q, mut v) = l.system.initial_state();
    v[0] = 0.02;
    let row = row(&mut l, 0.0, &q, &v);
    let stiffness = 2.07e5 * 78.5 / 500.0;
    let expected = [
        ("time", "second", 0.0),
        ("bar.N", "newton", stiffness * (1.0 + 1e-3 * 20.0)),
        ("bar.VY", "newton", 0.0),
        ("bar.VZ", "newton", 0.0),
        ("bar.T_J", "newton-mm", 0.0),
        ("bar.MY_J", "newton-mm", 0.0),
        ("bar.MZ_J", "newton-mm", 0.0),
        ("bar.T_I", "newton-mm", 0.0),
        ("bar.MY_I", "newton-mm", 0.0),
        ("bar.MZ_I", "newton-mm", 0.0),
        ("bar.ANGLE", "degrees", 0.0),
        ("bar.ENERGY", "newton-mm", 0.5 * stiffness),
        ("bar.POWER", "newton-mm/second", 1e-3 * stiffness * 400.0),
        ("bar.RESIDUAL", "", 0.0),
    ];
    let found: Vec<_> = names(&l);
    for ((name, unit, value), (found, actual)) in expected.iter().zip(found.iter().zip(&row)) {
        assert_eq!((found.0.as_str(), found.1.as_str()), (*name, *unit));
        assert!((actual - value).abs() <= 1e-9 * stiffness, "{name}: {actual} is not {value}");
    }
    assert_eq!(found.len(), expected.len());
}

/// Loads of a bent, twisted, moving beam balance to rounding, and with everything recorded the loads on I
/// stand before what goes through.
#[test]
fn the_residual_of_a_beam_is_rounding() {
    let mut b = Build::new(UnitSystem::mmks());
    let first = b.part("first", [3000.0, -2000.0, 500.0], 2.0, 100.0);
    let j = b.marker(first, "j", [50.0, 10.0, -20.0]);
    let second = b.part("second", [3400.0, -1980.0, 490.0], 3.0, 200.0);
    let i = b.marker(second, "i", [30.0, -25.0, 15.0]);
    b.numbers(i, "orientation", &[5.0, 25.0, 12.0]);
    b.beam("bar", i, j, 400.0);
    let mut l = lowered(&b, Options { record_all: true, ..Options::default() });
    let (q, _) = l.system.initial_state();
    let v: Vec<f64> = (0..12).map(|k| 0.1 * f64::from(k)).collect();
    let row = row(&mut l, 0.0, &q, &v);
    let value = |name: &str| row[column(&l, name)];
    assert!(value("bar.FX").abs() > 1.0 && value("bar.MZ_J").abs() > 1.0);
    assert!(value("bar.RESIDUAL") < 1e-13, "{}", value("bar.RESIDUAL"));
    assert_eq!(column(&l, "bar.N"), column(&l, "bar.TZ") + 1);
}

/// Truth: a bar of EA/L = 2.07e5 * 78.5 / 500 N/mm, 1 mm long too much, pulls I towards J: BEAM is
/// negative, and so is the load of the force request; on J it is positive.
#[test]
fn loads_of_beams_are_recorded_with_adams_signs() {
    let mut b = Build::new(UnitSystem::mmks());
    let j = b.marker(b.ground, "j", [0.0; 3]);
    let part = b.part("tip", [501.0, 0.0, 0.0], 2.0, 100.0);
    let i = b.marker(part, "i", [0.0; 3]);
    b.beam("bar", i, j, 500.0);
    let request = b.add("request", b.model, "REQ");
    b.word(request, "output_type", "force");
    b.refer(request, "i_marker_name", i);
    b.refer(request, "j_marker_name", j);
    let measure = b.add("measure_function", b.model, "on_j");
    b.function(measure, "function", "BEAM(.m.bar,1,2,0)");
    b.word(measure, "units", "force");
    let pt2pt = b.add("measure_pt2pt", b.model, "long");
    b.refer(pt2pt, "to_point", i);
    b.refer(pt2pt, "from_point", j);
    b.word(pt2pt, "characteristic", "translational_displacement");
    b.word(pt2pt, "component", "mag_component");
    let object = b.add("measure_object", b.model, "pull");
    let bar = b.database.find(".m.bar", "beam").unwrap();
    b.refer(object, "object", bar);
    b.word(object, "characteristic", "element_force");
    b.word(object, "component", "x_component");
    let mut l = lowered(&b, Options { record_all: true, ..Options::default() });
    let (q, v) = l.system.initial_state();
    let row = row(&mut l, 0.0, &q, &v);
    let pull = 2.07e5 * 78.5 / 500.0;
    for (name, unit, expected) in [
        ("REQ.X", "newton", -pull),
        ("REQ.MAG", "newton", pull),
        ("on_j.Q", "newton", pull),
        ("pull.Q", "newton", -pull),
        ("bar.FX", "newton", -pull),
        ("long.Q", "mm", 501.0),
        ("tip_XFORM.X", "mm", 501.0),
    ] {
        let at = column(&l, name);
        assert!((row[at] - expected).abs() < 1e-9 * pull, "{name}: {} is not {expected}", row[at]);
        assert_eq!(names(&l)[at].1, unit, "{name}");
    }
}

/// Truth: 30 degrees per second and 2 mm/s squared/2, from motions of displacement and acceleration.
#[test]
fn motions_follow_time_in_every_form() {
    let (mut b, joint) = wheel();
    let motion = b.add("motion", b.model, "drive");
    b.refer(motion, "joint_name", joint);
    for (form, function, start) in
        [("displacement", "30D*TIME", None), ("velocity", "30D", None), ("acceleration", "0", Some(30.0))]
    {
        b.word(motion, "time_derivative", form);
        b.function(motion, "function", function);
        if let Some(rate) = start {
            b.set(motion, "rotational_velocity_ic", rate);
        }
        let l = lowered(&b, Options::default());
        let mut system = l.system;
        let (q, _) = system.initial_state();
        let mut phi = vec![0.0; Dae::constraints(&system)];
        system.constraint_residual(2.0, &q, &mut phi).unwrap();
        assert!((phi[5] + std::f64::consts::FRAC_PI_3).abs() < 1e-12, "{form}: {}", phi[5]);
        system.constraint_velocity(2.0, &q, &mut phi).unwrap();
        assert!((phi[5] + std::f64::consts::FRAC_PI_6).abs() < 1e-12, "{form}: {}", phi[5]);
    }
}

#[test]
fn functions_that_cannot_be_read_are_named() {
    let (mut b, joint) = wheel();
    let motion = b.add("motion", b.model, "drive");
    b.refer(motion, "joint_name", joint);
    b.function(motion, "function", "DX(.m.nobody.cm)");
    let Err(found) = lower(&b.database, b.model, Options::default()) else { panic!("accepted") };
    let error = found.iter().find(|d| d.is_error()).unwrap();
    assert!(error.message.contains(".m.drive") && error.message.contains(".m.nobody.cm"), "{}", error.message);
}
