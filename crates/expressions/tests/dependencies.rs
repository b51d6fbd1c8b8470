//! Cells that hold expressions: frames, order, circles, undo.

mod common;
use common::*;
use model::Value;

/// Truth: p1 lies at x = 100 and is turned 90 degrees about z, `ref` at x = 150 global; so ref is at
/// (0, -50, 0) in p1.
#[test]
fn a_marker_gets_its_location_in_the_frame_of_its_part() {
    let mut f = fixture();
    set(&mut f.db, f.m1, "location", "LOC_RELATIVE_TO({0,0,0}, .m.ground.ref)").unwrap();
    let found = f.db.numbers(f.m1, "location").unwrap();
    assert!((found[0]).abs() < 1e-12 && (found[1] + 50.0).abs() < 1e-12, "{found:?}");
    set(&mut f.db, f.m1, "orientation", "ORI_RELATIVE_TO({0,0,0}, .m.ground.ref)").unwrap();
    assert!((f.db.numbers(f.m1, "orientation").unwrap()[0] + 90.0).abs() < 1e-12);
    // The part moves: the marker stays where ref is.
    let p1 = f.p1;
    place(&mut f.db, p1, [150.0, 20.0, 0.0], [0.0; 3]);
    let changed = [key(&f.db, p1, "location"), key(&f.db, p1, "orientation")];
    flexure_expressions::recompute(&mut f.db, &changed).unwrap();
    let pose = f.db.global_pose(f.m1);
    assert!((pose.origin - glam::DVec3::new(150.0, 0.0, 0.0)).length() < 1e-12, "{pose:?}");
}

/// Truth: by hand. A global value with `relative_to` the model's ground is converted to the part.
#[test]
fn relative_to_names_the_frame_of_the_value() {
    let mut f = fixture();
    let ground = f.db.find(".m.ground", "part").unwrap();
    f.db.set_value(f.m1, "relative_to", Value::Object(ground));
    set(&mut f.db, f.m1, "location", "LOC_GLOBAL({0,0,0}, .m.ground.ref)").unwrap();
    let found = f.db.numbers(f.m1, "location").unwrap();
    assert!(found[0].abs() < 1e-12 && (found[1] + 50.0).abs() < 1e-12, "{found:?}");
    let there = flexure_expressions::convert_location(&f.db, &[150.0, 0.0, 0.0], None, f.m1);
    assert!((there[1] + 50.0).abs() < 1e-12);
    let turned = flexure_expressions::convert_orientation(&f.db, &[0.0, 0.0, 0.0], None, f.m1);
    assert!((turned[0] + 90.0).abs() < 1e-12, "{turned:?}");
    // The same frame keeps every digit.
    let digits = [0.1 + 0.2, 1e-300, -0.0];
    assert_eq!(flexure_expressions::convert_location(&f.db, &digits, Some(f.p1), f.m1), digits);
}

#[test]
fn what_depends_is_computed_after_what_it_reads() {
    let mut f = fixture();
    let a = variable(&mut f.db, "a", "real_value", Value::Number(1.0));
    let b = variable(&mut f.db, "bb", "real_value", Value::Number(0.0));
    let c = variable(&mut f.db, "c", "real_value", Value::Number(0.0));
    // Bound in the wrong order on purpose: b = a + c, c = 2 a.
    set(&mut f.db, b, "real_value", ".m.a + .m.c").unwrap();
    set(&mut f.db, c, "real_value", "2 * .m.a").unwrap();
    set(&mut f.db, f.beam, "length", ".m.bb * 10.0").unwrap();
    assert_eq!(f.db.number(f.beam, "length"), Some(30.0));
    f.db.finish_step();
    f.db.set_value(a, "real_value", Value::Number(5.0));
    let changed = key(&f.db, a, "real_value");
    flexure_expressions::recompute(&mut f.db, &[changed]).unwrap();
    assert_eq!(f.db.number(f.beam, "length"), Some(150.0));
    assert!(f.db.undo());
    assert_eq!(f.db.number(f.beam, "length"), Some(30.0));
}

#[test]
fn circles_are_refused_by_name() {
    let mut f = fixture();
    let a = variable(&mut f.db, "a", "real_value", Value::Number(1.0));
    let b = variable(&mut f.db, "bb", "real_value", Value::Number(2.0));
    set(&mut f.db, b, "real_value", ".m.a + 1").unwrap();
    let error = f.db.transaction(|db| set(db, a, "real_value", ".m.bb")).unwrap_err();
    assert_eq!(error.code, "expression/circle");
    assert!(
        error.message.contains("`.m.a.real_value`") && error.message.contains("`.m.bb.real_value`"),
        "{}",
        error.message
    );
    assert_eq!(f.db.number(a, "real_value"), Some(1.0)); // rolled back
    let own = f.db.transaction(|db| set(db, a, "real_value", ".m.a * 2")).unwrap_err();
    assert_eq!(own.message, "`.m.a.real_value` would depend on itself");
}

#[test]
fn a_deleted_object_is_an_error_not_a_panic() {
    let mut f = fixture();
    let a = variable(&mut f.db, "a", "real_value", Value::Number(1.0));
    let kept = bound(&f.db, ".m.a * 2");
    f.db.remove(a);
    let sources = text::Sources::default();
    let scope = flexure_expressions::Scope::new(&f.db, &sources);
    assert_eq!(flexure_expressions::evaluate(&kept, &scope).unwrap_err().code, "expression/object-deleted");
}

/// Truth: documented: EXPR_STRING of a parametric location, empty for a plain one.
#[test]
fn expressions_can_be_asked_for_their_text() {
    let mut f = fixture();
    set(&mut f.db, f.m1, "location", "loc_relative_to({0,0,0}, ref)").unwrap();
    assert_eq!(text_value(&f.db, "EXPR_STRING(\"m1.location\")"), "(LOC_RELATIVE_TO({0, 0, 0}, .m.ground.ref))");
    assert_eq!(text_value(&f.db, "EXPR_STRING(\"m1.orientation\")"), "");
    assert_eq!(text_value(&f.db, "PARAM_STRING(\"m1.orientation\")"), "0.0d, 0.0d, 0.0d");
    near(&f.db, "EXPR_EXISTS(\"m1.location\")", &[1.0], 0.0);
}

/// Some elements of a list are expressions; the others keep their numbers.
#[test]
fn a_list_may_be_partly_expressions() {
    let mut f = fixture();
    let a = variable(&mut f.db, "a", "real_value", Value::Number(7.0));
    let cell = key(&f.db, f.m1, "location");
    let source = model::Source::Elements(Box::new(vec![None, Some(bound(&f.db, ".m.a * 2")), None]));
    let computed = flexure_expressions::compute(&f.db, cell, &source).unwrap();
    assert_eq!(computed.value.as_numbers().unwrap(), [10.0, 14.0, 0.0]);
    assert_eq!(computed.reads, [key(&f.db, a, "real_value")]);
}

/// A marker may aim from its own origin, and then its location may not follow its orientation.
#[test]
fn an_orientation_may_aim_from_the_origin_of_its_own_marker() {
    let mut f = fixture();
    let m1 = f.m1;
    let name = f.db.full_name(m1);
    set(&mut f.db, m1, "orientation", &format!("ORI_ALONG_AXIS({name}, .m.ground.ref, \"x\")")).unwrap();
    let aim =
        (f.db.global_pose(f.db.find(".m.ground.ref", "any").unwrap()).origin - f.db.global_pose(m1).origin).normalize();
    assert!((f.db.global_pose(m1).rotation.col(0) - aim).length() < 1e-12, "{aim}");
    let circle = f.db.transaction(|db| set(db, m1, "location", &format!("LOC_X_AXIS({name})"))).unwrap_err();
    assert_eq!(circle.code, "expression/circle");
}

/// Two markers may share an origin and an aim: the origin of a frame does not follow its turn.
#[test]
fn the_origin_of_a_frame_does_not_follow_its_turn() {
    let mut f = fixture();
    let (m1, reference) = (f.m1, f.db.find(".m.ground.ref", "any").unwrap());
    let name = f.db.full_name(m1);
    set(&mut f.db, reference, "orientation", &format!("ORI_ALONG_AXIS(.m.ground, {name}, \"x\")")).unwrap();
    set(&mut f.db, m1, "location", "LOC_RELATIVE_TO({0,0,0}, .m.ground.ref)").unwrap();
    let circle = f.db.transaction(|db| set(db, m1, "location", "LOC_RELATIVE_TO({1,0,0}, .m.ground.ref)")).unwrap_err();
    assert_eq!(circle.code, "expression/circle");
    assert!((f.db.global_pose(m1).origin - f.db.global_pose(reference).origin).length() < 1e-12);
}
