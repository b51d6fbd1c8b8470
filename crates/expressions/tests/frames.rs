//! Locations, orientations, distances, references, units, errors, and what depends on what.

mod common;
use common::*;
use model::{Array, Value};
use schema::Dimension;

/// Truth: documented examples where marked; the others by hand on the fixture: p1 at (100, 0, 0)
/// turned 90 degrees about z, its marker m1 at (10, 0, 0) in it, so at (100, 10, 0) global.
#[test]
fn locations() {
    let db = fixture().db;
    for (text, expected) in [
        ("LOC_GLOBAL({1,2,3}, .m.p1.m1)", [98.0, 11.0, 3.0]),
        ("LOC_LOCAL({98,11,3}, .m.p1.m1)", [1.0, 2.0, 3.0]),
        ("LOC_LOC({1,2,3}, .m.p1.m1, .m.ground.ref)", [-52.0, 11.0, 3.0]),
        ("LOC_LOC({1,2,3}, .m.p1.m1, 0)", [98.0, 11.0, 3.0]),
        ("LOC_LOC({1,2,3}, 0, .m.ground.ref)", [-149.0, 2.0, 3.0]),
        ("LOC_RELATIVE_TO({1,2,3}, .m.p1.m1)", [98.0, 11.0, 3.0]), // no owner: global
        (
            "LOC_ALONG_LINE(.m.p1.m1, .m.p2.cm, 5)",
            [100.0 - 5.0 * 97.0 / 9445.0_f64.sqrt(), 10.0 - 30.0 / 9445.0_f64.sqrt(), 0.0],
        ),
        ("LOC_CYLINDRICAL(1,30,0)", [0.75_f64.sqrt(), 0.5, 0.0]), // documented
        ("LOC_ON_LINE({{7,5,0},{15,11,0}},7)", [12.6, 9.2, 0.0]), // documented
        ("LOC_ON_AXIS(.m.p1.m1, 5, \"x\")", [100.0, 15.0, 0.0]),
        ("LOC_X_AXIS(.m.p1.m1)", [0.0, 1.0, 0.0]),
        ("LOC_Y_AXIS(.m.p1.m1)", [-1.0, 0.0, 0.0]),
        ("LOC_Z_AXIS(.m.p2.cm)", [0.0, -1.0, 0.0]),
        ("LOC_MIRROR({1,2,3}, .m.p1.m1, \"zx\")", [199.0, 2.0, 3.0]), // plane x = 100
        ("LOC_FRAME_MIRROR({1,2,3}, .m.p1.m1, \"xy\")", [1.0, 2.0, -3.0]),
        ("LOC_PLANE_MIRROR({2,4,5},{{10,12,0},{14,12,0},{12,10,0}})", [2.0, 4.0, -5.0]),
        ("LOC_PERPENDICULAR({{10,12,0},{14,12,0},{12,10,0}})", [10.0, 12.0, 1.0]), // documented
        ("LOC_INLINE({0,3,4}, .m.ground.ref, .m.ground.ref)", [0.0, 0.6, 0.8]),
    ] {
        near(&db, text, &expected, 1e-12);
    }
    near(&db, "LOC_SPHERICAL(10, 8D, 90D)", &[9.9, 1.39, 0.0], 5e-3); // documented, two decimals
}

/// Truth: documented examples, and the markers that real exports of Adams show with their
/// expression and its value (BHPlateCase, bh1: body-123 angles turned into axes by hand).
#[test]
fn orientations() {
    let mut f = fixture();
    let db = &mut f.db;
    let ground = db.find(".m.ground", "part").unwrap();
    for (name, at) in [
        ("a", [0.0; 3]),
        ("x", [-0.64018, 0.76822, 0.0]),
        ("z", [-0.39836, 0.0, -0.91723]),
        ("y", [-1.0, 1.0, 0.0]),
        ("n", [0.0, 0.0, -2.0]),
    ] {
        let id = db.create(&MARKER, Some(ground), name).unwrap();
        place(db, id, at, [0.0; 3]);
    }
    for (name, at) in [("e1", [100.0, 100.0, 0.0]), ("e2", [300.0, 300.0, 0.0]), ("e3", [350.0, 100.0, 0.0])] {
        let id = db.create(&MARKER, Some(ground), name).unwrap();
        place(db, id, at, [0.0; 3]);
    }
    for (text, expected) in [
        ("ORI_ALIGN_AXIS(.m.ground.a, \"z-z\")", [90.0, 180.0, 0.0]),
        ("ORI_ALIGN_AXIS(.m.ground.a, \"zz\")", [0.0, 0.0, 0.0]),
        ("ORI_ALL_AXES({{14,18,0},{10,14,0},{16,14,0}}, \"xz\")", [45.0, 90.0, 180.0]),
        ("ORI_IN_PLANE(.m.ground.e1, .m.ground.e2, .m.ground.e3, \"z_zy\")", [135.0, 90.0, 90.0]),
        ("ORI_MIRROR({{10,8,0}}, .m.ground.a, \"xy\", \"xy\")", [-170.0, 8.0, 180.0]), // 190 = -170
        ("ORI_FRAME_MIRROR({6,14,0}, .m.ground.a, \"xz\", \"xz\")", [174.0, 14.0, 180.0]),
        ("ORI_ALIGN_AXIS_EUL({8,10,0}, \"z-z\")", [-172.0, 170.0, 90.0]), // 188 = -172
        ("ORI_GLOBAL({10,0,0}, .m.p1.m1)", [100.0, 0.0, 0.0]),
        ("ORI_LOCAL({100,0,0}, .m.p1.m1)", [10.0, 0.0, 0.0]),
        ("ORI_ORI({10,0,0}, .m.p1.m1, .m.ground.ref)", [100.0, 0.0, 0.0]),
        ("ORI_RELATIVE_TO({10,0,0}, .m.p1.m1)", [100.0, 0.0, 0.0]),
        ("ORI_PLANE_MIRROR({10,0,0},{{0,0,0},{1,0,0},{0,1,0}}, \"xy\")", [10.0, 0.0, 0.0]),
    ] {
        let difference =
            format!("TMAT({text},\"body313\") - TMAT({{{},{},{}}},\"body313\")", expected[0], expected[1], expected[2]);
        near(db, &difference, &[0.0; 9], 1e-12);
    }
    // Columns x, y, z. Five decimals were read from the exports.
    let rows = |text: &str, expected: [f64; 9]| near(db, &format!("TMAT({text},\"body313\")"), &expected, 2e-5);
    let axes = [0.0, 0.0, 1.0, 0.76822, 0.64018, 0.0, -0.64018, 0.76822, 0.0];
    rows("ORI_ALONG_AXIS(.m.ground.a, .m.ground.x, \"z\")", axes);
    rows(
        "ORI_ALONG_AXIS(.m.ground.a, .m.ground.z, \"z\")",
        [-0.91723, 0.0, 0.39836, 0.0, 1.0, 0.0, -0.39836, 0.0, -0.91723],
    );
    let h = 0.5_f64.sqrt();
    rows("ORI_ALONG_AXIS(.m.ground.a, .m.ground.y, \"y\")", [h, h, 0.0, -h, h, 0.0, 0.0, 0.0, 1.0]);
    rows("ORI_ALONG_AXIS(.m.ground.a, .m.ground.n, \"z\")", [-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0]);
    rows("ORI_ALIGN_AXIS(.m.ground.a, \"zy\")", [0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    rows("ORI_ONE_AXIS({{10,16,0},{8,16,0}}, \"x\")", [-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0]);
}

/// Truth: by hand; m1 lies at (100, 10, 0) with axes x = Y, y = -X; cm at (3, 4, 0), turned 90
/// degrees about x.
#[test]
fn distances_and_angles() {
    let db = fixture().db;
    for (text, expected) in [
        ("DM(p1.m1, p2.cm)", 9445.0_f64.sqrt()),
        ("DX(p1.m1, p2.cm)", 97.0),
        ("DX(p1.m1, p2.cm, p1.m1)", 6.0),
        ("DY(p1.m1, p2.cm, p1.m1)", -97.0),
        ("DZ(p1.m1, p2.cm, p2.cm)", -6.0), // z of cm is -Y
        ("AZ(p1.m1, ground.ref)", 90.0),
        ("AX(p2.cm, ground.ref)", 90.0),
        ("AY(p2.cm, ground.ref)", 0.0),
        ("PSI(p1.m1, ground.ref)", 90.0),
        ("THETA(p2.cm, ground.ref)", 90.0),
        ("PHI(p2.cm, ground.ref)", 0.0),
        ("YAW(p1.m1, ground.ref)", 90.0),
        ("PITCH(p1.m1, ground.ref)", 0.0),
        ("ROLL(p2.cm, ground.ref)", 90.0),
    ] {
        near(&db, text, &[expected], 1e-12);
    }
}

#[test]
fn names_reach_objects_attributes_and_variables() {
    let mut f = fixture();
    let width = variable(&mut f.db, "width", "real_value", Value::Number(12.5));
    variable(&mut f.db, "list", "real_value", Value::Array(Array::column(vec![4.0, 5.0, 6.0])));
    variable(&mut f.db, "mk", "string_value", Value::Text("p1.m1".into()));
    let m1 = f.m1;
    variable(&mut f.db, "obj", "object_value", Value::Object(m1));
    let db = &mut f.db;
    near(db, "width * 2", &[25.0], 0.0);
    near(db, ".m.list[2] + .M.LIST[3]", &[11.0], 0.0);
    near(db, "p1.m1.location[1] + .m.p1.m1.loc[2] + m1.location[1]", &[20.0], 0.0);
    near(db, "DM(mk, .m.p1.m1) + DM(obj, m1)", &[0.0], 0.0);
    near(db, "obj.object_value.location[1] + .m.obj.location[1]", &[20.0], 0.0);
    assert_eq!(value(db, ".m.b.i"), Value::Object(m1));
    assert_eq!(value(db, ".m.width.self"), Value::Object(width));
    assert_eq!(value(db, ".m.p1.parent == .m"), Value::Integer(1));
    // Renaming is followed: the tree holds the object, not its name.
    let kept = bound(db, "width * 2");
    assert_eq!(flexure_expressions::print(&kept, db), ".m.width * 2");
    db.rename(width, Some(f.m), "total width").unwrap();
    assert_eq!(flexure_expressions::print(&kept, db), ".m.\"total width\" * 2");
    assert_eq!(bound(db, ".m.\"total width\" * 2"), kept);
}

#[test]
fn eval_is_folded_into_literals() {
    let mut f = fixture();
    variable(&mut f.db, "i", "real_value", Value::Number(3.0));
    let kept = bound(&f.db, "\"m_\" // RTOI(eval(i)) // \".cm\"");
    assert_eq!(flexure_expressions::print(&kept, &f.db), "\"m_\" // RTOI(3.0) // \".cm\"");
    let negative = bound(&f.db, "1 + eval(-i)");
    assert_eq!(bound(&f.db, &flexure_expressions::print(&negative, &f.db)), negative);
    match bound_for(&f.db, "eval(loc_global({200,0,0}, .m.p1.m1))", None) {
        Ok(flexure_expressions::Bound::Value(v)) => {
            assert!((v.value.as_numbers().unwrap()[1] - 210.0).abs() < 1e-12);
            assert!(
                v.reads.contains(&key(&f.db, f.m1, "location")) && v.reads.contains(&key(&f.db, f.p1, "orientation"))
            );
        }
        other => panic!("{other:?}"),
    }
}

/// Truth: factors by definition; density and modulus as exports show them, ten digits.
#[test]
fn units_convert_and_give_their_dimension() {
    let mut f = fixture();
    for (text, expected, dimension) in [
        ("0.5inch", 12.7, Some(Dimension::LENGTH)),
        ("2 * 10.0cm", 200.0, Some(Dimension::LENGTH)),
        ("(2cm)**2", 400.0, Some(Dimension::AREA)),
        ("0.42newton", 0.42, Some(Dimension::FORCE)),
        ("10mm", 10.0, Some(Dimension::LENGTH)),
        ("2cm + 3cm", 50.0, Some(Dimension::LENGTH)),
        ("2cm + 3", 23.0, None),
        ("2cm / 1mm", 20.0, None),
        ("2 * 3", 6.0, None),
        ("ABS(2cm)", 20.0, None),
        ("90d", 90.0, Some(Dimension::ANGLE)),
        ("7801.0(kg/meter**3)", 7801e-9, Some(Dimension::DENSITY)),
    ] {
        let found = evaluated(&f.db, text).unwrap();
        let x = found.value.as_number().unwrap();
        assert!((x - expected).abs() <= 1e-12 * expected, "{text} = {x}");
        assert_eq!(found.dimension, dimension, "{text}");
    }
    let ips = schema::UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees").unwrap();
    f.db.set_units(ips);
    near(&f.db, "7801.0(kg/meter**3)", &[0.281_829_004_9], 5e-11);
    near(&f.db, "2.07E+11(Newton/meter**2)", &[3.002_281_171e7], 5e-3);
    near(&f.db, ".m.b.length", &[420.0 / 25.4], 1e-12);
}

#[test]
fn errors_speak_like_adams_and_help() {
    let db = fixture().db;
    let arity = error(&db, "eval(loc_relative_to({0,0,150}, .m.p1.m1, .m.ground.ref))");
    assert_eq!(arity.code, "expression/wrong-argument-count");
    assert_eq!(arity.adams_text[0], "The function LOC_RELATIVE_TO expects 2 arguments, found 3");
    assert_eq!(arity.adams_text[1], "(eval(loc_relative_to({0,0,150}, .m.p1.m1, .m.ground.ref<<)>>))");
    let empty = error(&db, "eval()");
    assert_eq!(empty.adams_text, ["The function EVAL expects 1 arguments, found 0", "(eval(<<)>>)"]);
    let unknown = error(&db, ".model.analysis != 1");
    assert_eq!(unknown.code, "expression/unknown-name");
    assert_eq!(unknown.adams_text[0], "\"model\" is not a known constant, function or variable");
    assert_eq!(unknown.adams_text[1], "(.<<model>>.analysis != 1)");
    let child = error(&db, ".m.p1.inputs[1]");
    assert_eq!(child.code, "expression/unknown-attribute");
    assert_eq!(child.adams_text[0], "\"inputs\" is neither a field in nor a child of \".m.p1\"");
    assert_eq!(child.adams_text[1], "(.m.p1.<<inputs>>[1])");
    assert_eq!(error(&db, ".m.p1.locatoin").helps[0].text, "did you mean `location`?");
    assert_eq!(error(&db, "LOC_RELATIV_TO({0,0,0}, m1)").helps[0].text, "did you mean `LOC_RELATIVE_TO`?");
    for (text, code) in [
        ("FFTMAG({1,2})", "expression/function-not-supported"),
        ("FOO(1)", "expression/unknown-function"),
        ("2furlong", "expression/unknown-unit"),
        ("1/0", "expression/division-by-zero"),
        ("10.0**400", "expression/not-finite"),
        ("EXP(1000)", "expression/not-finite"),
        ("{1,2}[3]", "expression/index-out-of-range"),
        ("{1,2} + {1,2,3}", "expression/shapes-differ"),
        ("SQRT(-1)", "expression/wrong-argument"),
        ("LOC_GLOBAL({1,2}, m1)", "expression/wrong-argument"),
        ("LOC_ALONG_LINE(m1, m1, 1)", "expression/wrong-argument"),
        ("\"a\" * 2", "expression/not-a-number"),
        ("INVERSE({[1,2],[2,4]})", "expression/wrong-argument"),
        ("STOO(\"nobody\")", "expression/no-such-object"),
        ("{1,.m}", "expression/mixed-array"),
    ] {
        assert_eq!(error(&db, text).code, code, "{text}");
    }
    // Every wrong name is reported, not the first alone.
    assert_eq!(bound_for(&db, "aa1 + bb2", None).unwrap_err().len(), 2);
}
