//! Datasets written from models: layout, numbers of objects, comments, what is left out.

mod support;

use flexure_dataset::{Digits, Mass, Options, number_objects, write};
use model::{ObjectId, Piece, Value};
use schema::UnitSystem;
use support::{Bench, text};

/// A beam from ground to a part that hangs on a driven joint.
fn swing() -> (Bench, ObjectId) {
    let mut b = Bench::new("swing", UnitSystem::mmks());
    let (ground, model) = (b.ground, b.model);
    let j = b.marker(ground, "J", 0, [0.0; 3], [0.0; 3]);
    let part = b.add("part", model, "bar", 0);
    b.numbers(part, "location", &[100.0, 0.0, 0.0]);
    b.number(part, "wz", 90.0);
    b.set(part, "exact_coordinates", Value::Texts(vec!["x".into(), "psi".into()]));
    let i = b.marker(part, "I", 0, [0.0, 0.5, 0.0], [-90.0, 0.0, 0.0]);
    let cm = b.marker(part, "cm", 0, [0.0; 3], [0.0; 3]);
    b.mass(part, 2.0, cm, [10.0, 20.0, 30.0]);
    b.number(part, "iyz", 0.5);
    let beam = b.model_object("beam", "beam1", 0);
    b.between(beam, i, j);
    for (field, x) in [
        ("length", 100.0),
        ("area_of_cross_section", 12.5),
        ("y_shear_area_ratio", 0.0),
        ("z_shear_area_ratio", 1.2),
        ("youngs_modulus", 2.07e5),
        ("shear_modulus", 79_300.0),
        ("ixx", 17.1),
        ("iyy", 8.0),
        ("izz", 13.0),
        ("damping_ratio", 0.01),
    ] {
        b.number(beam, field, x);
    }
    b.word(beam, "formulation", "linear");
    b.set(beam, "comments", Value::Texts(vec!["the only spring".into()]));
    let motion = b.model_object("motion", "drive", 0);
    b.between(motion, i, j);
    b.word(motion, "axis", "z");
    b.word(motion, "time_derivative", "velocity");
    b.function(motion, "function", vec![text("10*STEP(TIME, 0, 0, 1, DX("), Piece::Object(i), text("))")]);
    let gravity = b.database.create(b.registry.class("gravity").unwrap(), Some(model), "g").unwrap();
    b.number(gravity, "x_component_gravity", 0.0);
    b.number(gravity, "y_component_gravity", -9806.65);
    b.set(model, "comments", Value::Texts(vec!["a model of".into(), "one beam".into()]));
    (b, beam)
}

/// Memory of the layout; the parts that exports show are checked against them in `corpus.rs`.
#[test]
fn a_small_model_is_written_in_the_layout_of_exports() {
    let (mut b, _) = swing();
    let expected = "\
Adams View model name: swing
! a model of
! one beam
! END OF MODEL COMMENTS
!
!-------------------------------- SYSTEM UNITS ---------------------------------
!
UNITS/
, FORCE = NEWTON
, MASS = KILOGRAM
, LENGTH = MILLIMETER
, TIME = SECOND
!
!----------------------------------- PARTS -------------------------------------
!
!----------------------------------- Ground ------------------------------------
!
!                            adams_view_name='ground'
PART/1
, GROUND
!
!                              adams_view_name='J'
MARKER/1
, PART = 1
!
!------------------------------------ Part -------------------------------------
!
!                             adams_view_name='bar'
PART/2
, QG = 100, 0, 0
, WZ = 90
, EXACT = X:PSI
, MASS = 2
, CM = 3
, IP = 10, 20, 30, 0, 0, 0.5
!
!                              adams_view_name='I'
MARKER/2
, PART = 2
, QP = 0, 0.5, 0
, REULER = 270D, 0D, 0D
!
!                              adams_view_name='cm'
MARKER/3
, PART = 2
!
!-------------------------------- CONSTRAINTS ----------------------------------
!
!                            adams_view_name='drive'
MOTION/1
, I = 2
, J = 1
, Z
, VELOCITY
, FUNCTION = 10*STEP(TIME, 0, 0, 1, DX(2))
!
!----------------------------------- FORCES ------------------------------------
!
! the only spring
!                            adams_view_name='beam1'
BEAM/1
, I = 2
, J = 1
, LENGTH = 100
, IXX = 17.1
, IYY = 8
, IZZ = 13
, AREA = 12.5
, ASZ = 1.2
, EMODULUS = 2.07E+05
, GMODULUS = 79300
, CRATIO = 0.01
, FORMULATION = LINEAR
!
!------------------------- GRAVITATIONAL ACCELERATION --------------------------
!
!                              adams_view_name='g'
ACCGRAV/
, JGRAV = -9806.65
!
!----------------------------- ANALYSIS SETTINGS -------------------------------
!
OUTPUT/
, REQSAVE
, GRSAVE
!
RESULTS/
, XRF
!
END
";
    let written = b.written();
    assert_eq!(written.text, expected);
    assert_eq!(written.warnings, []);
}

/// The rule of adams_id: 0 becomes a free number, once and for all; a number given is used.
#[test]
fn numbers_are_given_once_and_kept() {
    let (mut b, beam) = swing();
    assert!(b.text().contains("\nBEAM/1\n"));
    assert_eq!(b.database.integer(beam, "adams_id"), Some(1));
    let other = b.model_object("beam", "beam2", 0);
    let ends = ["i_marker_name", "j_marker_name"].map(|f| b.database.reference(beam, f).unwrap());
    b.between(other, ends[0], ends[1]);
    b.set(beam, "adams_id", Value::Integer(12));
    let first = b.text();
    assert!(first.contains("\nBEAM/12\n") && first.contains("\nBEAM/1\n"));
    assert_eq!(b.text(), first, "a second dataset has the same numbers");
}

#[test]
fn two_objects_with_one_number_are_refused_and_nothing_is_numbered() {
    let (mut b, beam) = swing();
    b.set(beam, "adams_id", Value::Integer(3));
    b.model_object("beam", "beam2", 3);
    let waiting = b.model_object("beam", "beam3", 0);
    let errors = number_objects(&mut b.database, b.model).unwrap_err();
    assert_eq!(errors[0].code, "dataset/duplicate-id");
    assert_eq!(errors[0].message, "`.swing.beam1` and `.swing.beam2` are both BEAM/3");
    assert_eq!(b.database.integer(waiting, "adams_id"), Some(0));
}

/// A model in inch and pounds: the same beam in other units.
#[test]
fn values_follow_the_units_in_force() {
    let (mut b, _) = swing();
    b.database.set_units(UnitSystem::named("meter", "kg", "second", "newton", "radians").unwrap());
    let text = b.text();
    assert!(text.contains(", LENGTH = METER\n"));
    assert!(text.contains(", LENGTH = 0.1\n"));
    assert!(text.contains(", EMODULUS = 2.07E+11\n"));
    assert!(text.contains(", REULER = 270D, 0D, 0D\n"), "angles are in degrees whatever the model says");
    assert!(text.contains(", WZ = 90\n"), "angular velocities are in radians whatever the model says");
}

#[test]
fn a_broken_reference_makes_the_statement_a_comment_that_names_both_ends() {
    let (mut b, beam) = swing();
    b.set(beam, "i_marker_name", Value::Object(b.model));
    let written = b.written();
    assert_eq!(written.warnings.len(), 1);
    assert_eq!(written.warnings[0].message, "`.swing.beam1` refers to `.swing`, which has no place in a dataset");
    assert!(written.text.contains("\n! not written: `.swing.beam1` refers to `.swing`, which"));
    assert!(written.text.contains("\n!BEAM/1\n!, I = .swing\n!, J = 1\n!, LENGTH = 100\n"), "{}", written.text);
    assert!(!written.text.contains("\nBEAM") && written.text.contains("\nMOTION/1\n"));
}

/// A motion without a place takes what refers to it along, though that comes earlier in the text.
#[test]
fn what_refers_to_an_unwritten_object_is_not_written_either() {
    let (mut b, beam) = swing();
    let (ground, model) = (b.ground, b.model);
    let arrow = b.add("force_graphic", ground, "arrow", 0);
    b.set(arrow, "force_element_name", Value::Object(beam));
    assert!(b.text().contains("\n, ETYPE = BEAM\n, EID = 1\n"));
    b.set(beam, "i_marker_name", Value::Object(model));
    let written = b.written();
    let messages: Vec<_> = written.warnings.iter().map(|w| w.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "`.swing.ground.arrow` refers to `.swing.beam1`, which is not written",
            "`.swing.beam1` refers to `.swing`, which has no place in a dataset"
        ]
    );
    assert!(!written.text.contains("\nGRAPHICS") && written.text.contains("\n!GRAPHICS/1\n"));
}

/// Names the model does not have, as behind a data element that is not supported.
#[test]
fn functions_with_unknown_names_become_comments() {
    let (mut b, _) = swing();
    let joint = b.model_object("motion", "spin", 0);
    b.word(joint, "axis", "z");
    b.function(joint, "function", vec![text("VARVAL(.swing.speed)*TIME")]);
    let request = b.model_object("request", "r", 0);
    b.function(request, "f2", vec![text("VARVAL(.swing.speed)")]);
    b.function(request, "f3", vec![text("TIME")]);
    let other = b.model_object("request", "s", 0);
    b.function(other, "f2", vec![text("ARYVAL(.swing.states, 5)")]);
    let written = b.written();
    let messages: Vec<_> = written.warnings.iter().map(|w| w.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "`.swing.spin` refers to `.swing.speed`, which is no object",
            "`.swing.r` refers to `.swing.speed`, which is no object: `F2 = VARVAL(.swing.speed)`",
            "`.swing.s` refers to `.swing.states`, which is no object: `F2 = ARYVAL(.swing.states, 5)`",
            "`.swing.s` has no component that can be written",
        ]
    );
    assert!(written.text.contains("\n!MOTION/2\n!, Z\n!, FUNCTION = VARVAL(.swing.speed)*TIME\n"));
    assert!(written.text.contains("\nREQUEST/1\n, F3 = TIME\n"));
    assert!(written.text.contains("\n!REQUEST/2\n"));
    // Every message is in the text, and no statement has a name.
    assert!(messages.iter().all(|m| written.text.contains(&format!("\n! not written: {m}\n"))));
    assert!(written.text.lines().skip(1).all(|l| l.starts_with('!') || !l.contains(".swing")));
}

/// Ids are unique within a statement only: the number of a beam would be that of some marker.
#[test]
fn a_function_that_names_an_object_of_another_class_is_not_written() {
    let (mut b, beam) = swing();
    let request = b.model_object("request", "r", 0);
    b.function(request, "f2", vec![text("STEP(TIME, 0, 0, 1, DX("), Piece::Object(beam), text("))")]);
    b.function(request, "f3", vec![text("BEAM("), Piece::Object(beam), text(",0,2)")]);
    let written = b.written();
    let [warning] = written.warnings.as_slice() else { panic!("{:?}", written.warnings) };
    assert_eq!(warning.code, "dataset/wrong-object");
    assert!(
        warning.message.starts_with("the function of `.swing.r` needs a MARKER where it names `.swing.beam1`, a Beam"),
        "{}",
        warning.message
    );
    assert!(written.text.contains("\nREQUEST/1\n, F3 = BEAM(1,0,2)\n"), "{}", written.text);
}

/// A variable stands for its value in functions, be it a number or an object.
#[test]
fn variables_in_functions_become_what_they_hold() {
    let (mut b, beam) = swing();
    let class = b.registry.class("variable").unwrap();
    let marker = b.database.reference(beam, "i_marker_name").unwrap();
    let mut variable = |name: &str, field: &str, value: Value| {
        let id = b.database.create(class, Some(b.model), name).unwrap();
        b.database.set_value(id, field, value);
        Piece::Object(id)
    };
    let direction = variable("direction", "object_value", Value::Objects(vec![marker]));
    let count = variable("count", "integer_value", Value::Integer(-3));
    let request = b.model_object("request", "r", 0);
    b.function(request, "f2", vec![text("2*"), count, text("*WZ("), direction, text(")")]);
    let written = b.written();
    assert_eq!(written.warnings, []);
    assert!(written.text.contains("\n, F2 = 2*(-3)*WZ(2)\n"), "{}", written.text);
}

#[test]
fn a_mass_without_a_marker_at_its_centre_is_not_written() {
    let (mut b, _) = swing();
    let part = b.model_object("part", "plain", 0);
    b.number(part, "mass", 1.5);
    b.number(part, "ixx", 4.0);
    let written = b.written();
    assert_eq!(written.warnings.len(), 1);
    assert_eq!(written.warnings[0].code, "dataset/no-centre-of-mass");
    assert!(written.text.contains("\nPART/3\n!\n"), "{}", written.text);
    b.marker(part, "cm", 7, [0.0; 3], [0.0; 3]);
    let written = b.written();
    assert_eq!(written.warnings, []);
    assert!(written.text.contains("\nPART/3\n, MASS = 1.5\n, CM = 7\n, IP = 4, 0, 0\n"));
}

/// Products from rounding are zero; the smallest that count are written.
#[test]
fn products_of_inertia_from_rounding_are_left_out() {
    let (mut b, beam) = swing();
    let marker = b.database.reference(beam, "i_marker_name").unwrap();
    let part = b.database.object(marker).parent.unwrap();
    b.number(part, "iyz", -2.1e-19);
    assert!(b.text().contains("\n, IP = 10, 20, 30\n"));
    b.number(part, "iyz", 3.1e-11);
    assert!(b.text().contains("\n, IP = 10, 20, 30, 0, 0, 3.1E-11\n"));
}

/// Truth: two exports of models that state 1.0E-05 for HHT, whose INTEGRATOR has no ERROR.
#[test]
fn the_error_an_integrator_has_anyway_is_left_out() {
    let (mut b, _) = swing();
    let class = b.registry.class("numerical_integration_parameters").unwrap();
    let settings = b.database.create(class, Some(b.model), "numerical").unwrap();
    b.word(settings, "integrator_type", "hht");
    b.number(settings, "error_tolerance", 1e-5);
    assert!(b.text().contains("\nINTEGRATOR/\n, HHT\n!\n"));
    b.number(settings, "error_tolerance", 1e-3);
    assert!(b.text().contains("\nINTEGRATOR/\n, HHT\n, ERROR = 0.001\n!\n"));
}

#[test]
fn inactive_objects_become_comments() {
    let (mut b, beam) = swing();
    b.word(beam, "active", "off");
    let text = b.text();
    assert!(text.contains("\n!BEAM/1\n!, I = 2\n"));
    assert!(!text.contains("\nBEAM/1"));
}

#[test]
fn masses_that_follow_from_shapes_are_asked_for() {
    let (mut b, _) = swing();
    let part = b.model_object("part", "plain", 0);
    let written = b.written();
    assert_eq!(written.warnings[0].code, "dataset/no-mass");
    assert!(written.text.contains("! not written: the mass of `.swing.plain` is not given\n"));
    let cm = b.marker(part, "centre", 0, [0.0; 3], [0.0; 3]);
    let given = |_: &model::Database, id: ObjectId| {
        // The products are what is left of shapes along the axes an export calls principal.
        let inertia = [1.0, 2.0, 3.0, 0.0, 2e-9, 0.0];
        let mass = Mass { mass: 1.5, center: Some(cm), inertia_marker: None, inertia };
        (id == part).then_some(mass)
    };
    let options = Options { mass: Some(&given), ..Options::default() };
    let written = write(&mut b.database, b.model, options).unwrap();
    assert_eq!(written.warnings, []);
    assert!(written.text.contains("PART/3\n, MASS = 1.5\n, CM = 4\n, IP = 1, 2, 3\n"));
}

#[test]
fn shapes_the_solver_does_not_know_are_counted() {
    let (mut b, _) = swing();
    let ground = b.ground;
    b.add("link", ground, "l1", 0);
    b.add("link", ground, "l2", 0);
    let written = b.written();
    assert_eq!(written.warnings.len(), 1);
    assert_eq!(written.warnings[0].message, "2 Link: shapes without a statement, which change no result");
    assert!(!written.text.contains("GRAPHICS"));
}

#[test]
fn requests_end_all_functions_but_the_last() {
    let (mut b, beam) = swing();
    let request = b.model_object("request", "r", 0);
    b.word(request, "comment", "tip, load");
    b.set(request, "component_names", Value::Texts(vec![String::new(), "a b".into()]));
    b.function(request, "f2", vec![text("BEAM("), Piece::Object(beam), text(",0,2,0)")]);
    b.function(request, "f3", vec![text("TIME ")]);
    b.function(request, "f4", vec![text("")]);
    let text = b.text();
    let expected = "REQUEST/1\n, COMMENT = tip, load\n, CNAMES = \"\", \"a b\"\n, F2 = BEAM(1,0,2,0)\\\n, F3 = TIME\n!";
    assert!(text.contains(expected), "{text}");
}

#[test]
fn exact_digits_read_back_the_same() {
    let (mut b, beam) = swing();
    b.number(beam, "length", 100.0 / 3.0);
    let options = Options { digits: Digits::Exact, ..Options::default() };
    let written = write(&mut b.database, b.model, options).unwrap();
    assert!(written.text.contains(&format!(", LENGTH = {}\n", 100.0 / 3.0)));
    assert!(b.text().contains(", LENGTH = 33.33333333\n"));
}

/// Nothing is left out silently: one warning for each kind.
#[test]
fn measures_and_spring_graphics_are_reported_by_kind() {
    let (mut b, _) = swing();
    let ground = b.ground;
    b.add("spring_damper_graphic", ground, "s1", 0);
    for name in ["m1", "m2"] {
        let class = b.registry.class("measure_object").unwrap();
        b.database.create(class, Some(b.model), name).unwrap();
    }
    let warnings = b.written().warnings;
    assert_eq!(warnings.len(), 2, "{warnings:#?}");
    assert!(warnings.iter().any(|w| w.message.ends_with("measures are not part of a dataset")));
    assert!(warnings.iter().any(|w| w.message.ends_with("not written yet, which change no result")));
}

/// Rows of a surface that cannot be told from one another are not written as others.
#[test]
fn a_surface_with_uneven_rows_is_not_written() {
    let (mut b, _) = swing();
    let spline = b.model_object("spline", "s", 0);
    b.numbers(spline, "x", &[1.0, 2.0]);
    b.numbers(spline, "z", &[0.0, 1.0]);
    b.numbers(spline, "y", &[1.0, 2.0, 3.0]);
    let written = b.written();
    assert_eq!(written.warnings.len(), 1);
    assert_eq!(written.warnings[0].code, "dataset/uneven-surface");
    assert_eq!(written.warnings[0].message, "`.swing.s` has 3 values for 2 rows");
    assert!(written.text.contains("\n!SPLINE/1\n"), "{}", written.text);
    b.numbers(spline, "y", &[1.0, 2.0, 3.0, 4.0]);
    assert!(b.text().contains("\nSPLINE/1\n, X = 1, 2\n, Y = 0, 1, 2\n, Y = 1, 3, 4\n"));
}
