//! Functions that ask the database.

mod common;
use common::*;
use model::{Database, ObjectId, Value};

fn names(db: &Database, call: &str) -> Vec<String> {
    let list: Vec<ObjectId> = match value(db, call) {
        Value::Objects(list) => list,
        Value::Object(one) => vec![one],
        Value::Array(a) if a.values.is_empty() => Vec::new(),
        other => panic!("{call}: {other:?}"),
    };
    list.into_iter().map(|o| db.full_name(o)).collect()
}

fn texts(db: &Database, call: &str) -> Vec<String> {
    match value(db, call) {
        Value::Texts(list) => list,
        other => panic!("{call}: {other:?}"),
    }
}

/// The fixture with a marker placed by a variable and by another marker, and a beam between two.
fn parametric() -> Fixture {
    let mut f = fixture();
    let length = variable(&mut f.db, "len", "real_value", Value::Number(5.0));
    f.db.set_value(length, "units", Value::Text("length".into()));
    let m1 = f.m1;
    set(&mut f.db, m1, "location", "LOC_RELATIVE_TO({len, 0, 0}, .m.ground.ref)").unwrap();
    f
}

/// Truth: what the fixture was built from.
#[test]
fn who_refers_to_whom() {
    let f = parametric();
    let db = &f.db;
    assert_eq!(names(db, "DB_REFERENTS(p1.m1, \"all\")"), [".m.len", ".m.ground.ref"]);
    assert_eq!(names(db, "DB_REFERENTS(p1.m1, \"marker\")"), [".m.ground.ref"]);
    assert_eq!(names(db, "DB_REFERENTS(.m.b, \"all\")"), [".m.p1.m1"]);
    assert_eq!(names(db, "DB_REFERENTS_EXHAUSTIVE(.m.b, \"all\")"), [".m.p1.m1", ".m.len", ".m.ground.ref"]);
    assert_eq!(names(db, "DB_DEPENDENTS(.m.len.self, \"marker\")"), [".m.p1.m1"]);
    assert_eq!(names(db, "DB_DEPENDENTS(.m.len.self, \"beam\")"), [""; 0]);
    assert_eq!(names(db, "DB_DEPENDENTS_EXHAUSTIVE(.m.len.self, \"all\")"), [".m.p1.m1", ".m.b"]);
    assert_eq!(names(db, "DB_DEPENDENTS_EXHAUSTIVE(.m.len.self, \"force\")"), [".m.b"]);
    assert_eq!(names(db, "DB_DELETE_DEPENDENTS(.m.p1)"), [".m.b"]);
    assert_eq!(names(db, "DB_DELETE_DEPENDENTS(.m.p2)"), [""; 0]);
    assert_eq!(names(db, "DB_DEL_PARAM_DEPENDENTS(.m.ground.ref)"), [".m.p1.m1"]);
    assert_eq!(names(db, "DB_DEL_PARAM_DEPENDENTS(.m.p1.m1)"), [""; 0]);
    assert_eq!(names(db, "DB_TWO_WAY(.m, \"all\")"), [""; 0]);
    near(db, "EXPR_REFERENCES(\".m.p1.m1.loc\") + 10*EXPR_REFERENCES(\".m.p1.m1.orientation\")", &[2.0], 0.0);
    assert_eq!(text_value(db, "EXPR_REFERENCE(\".m.p1.m1.loc\", 1)"), ".m.len");
    assert_eq!(text_value(db, "EXPR_REFERENCE(\".m.p1.m1.loc\", 2)"), ".m.ground.ref");
    assert_eq!(text_value(db, "EXPR_REFERENCE(\".m.p1.m1.loc\", 3)"), "");
    assert_eq!(text_value(db, "EXPR_REFERENCE(\".m.p1.m1.loc\", 0)"), "");
}

/// Case 84: the normalised text of an expression, and nothing for a plain value.
#[test]
fn fields_as_texts() {
    let f = parametric();
    let db = &f.db;
    assert_eq!(text_value(db, "EXPR_STRING(\"m1.location\")"), "(LOC_RELATIVE_TO({.m.len, 0, 0}, .m.ground.ref))");
    assert_eq!(text_value(db, "EXPR_STRING(\"m1.orientation\")"), "");
    assert_eq!(text_value(db, "PARAM_STRING(\".m.ground.ref.location\")"), "150.0, 0.0, 0.0");
    assert_eq!(text_value(db, "PARAM_STRING(\".m.p2.cm.orientation\")"), "0.0d, 90.0d, 0.0d");
    assert_eq!(text_value(db, "USER_STRING(\".m.p2.cm.orientation\")"), "0.0, 90.0, 0.0");
    assert_eq!(text_value(db, "PARAM_STRING(\".m.len.units\")"), "\"length\"");
    assert_eq!(text_value(db, "USER_STRING(\".m.len.units\")"), "length");
    assert_eq!(text_value(db, "USER_STRING(\".m.len\")"), "5.0");
    assert_eq!(text_value(db, "USER_STRING(\".m.b.i\")"), ".m.p1.m1");
    assert_eq!(error(db, "USER_STRING(\".m.b.nothing\")").code, "expression/wrong-argument");
}

/// Truth: the classes of the fixture.
#[test]
fn fields_of_a_type() {
    let f = parametric();
    let db = &f.db;
    let marker = ["adams_id", "location", "orientation", "relative_to"];
    assert_eq!(texts(db, "DB_TYPE_FIELDS(\"marker\")"), marker);
    // The short names i, j and ID beside the fields.
    assert_eq!(texts(db, "DB_FULL_TYPE_FIELDS(\"Beam\")").len(), texts(db, "DB_TYPE_FIELDS(\"beam\")").len() + 3);
    for (field, expected) in
        [("length", "REAL"), ("adams_id", "INTEGER"), ("i_marker_name", "OBJECT"), ("values", "REAL")]
    {
        assert_eq!(text_value(db, &format!("DB_FIELD_TYPE(\"beam\",\"{field}\")")), expected);
    }
    assert_eq!(text_value(db, "DB_FIELD_TYPE(\"marker\",\"location\")"), "LOCATION");
    let filtered = |filters: &str| {
        texts(db, &format!("DB_FIELD_FILTER({{\"object_type=beam\",{filters}}}, DB_FULL_TYPE_FIELDS(\"beam\"))"))
    };
    assert_eq!(filtered("\"t=real\",\"c=1\""), ["length", "youngs_modulus"]);
    assert_eq!(filtered("\"t=integer\""), ["adams_id", "ID"]);
    assert_eq!(filtered("\"t=marker\",\"alias=true\""), ["i", "j"]);
    assert_eq!(filtered("\"assoc=reference\",\"alias:false\""), ["i_marker_name", "j_marker_name"]);
    let found = error(db, "DB_TYPE_FIELDS(\"beem\")");
    assert!(found.helps.iter().any(|h| h.text.contains("beam")), "{found:?}");
    assert!(error(db, "DB_FIELD_FILTER({\"t=real\"},{\"length\"})").message.contains("object_type="));
}

/// Truth: help pages' examples, carried over to the fixture.
#[test]
fn ancestors_names_and_activity() {
    let mut f = parametric();
    {
        let db = &f.db;
        assert_eq!(names(db, "DB_OLDEST_ANCESTOR(.m.p1.m1,\"model\")"), [".m"]);
        assert_eq!(value(db, "DB_OLDEST_ANCESTOR(.m.p1.m1,\"beam\")"), Value::Nothing);
        assert_eq!(names(db, "DB_OBJ_FROM_NAME_TYPE(.m, \"M1\", \"marker\")"), [".m.p1.m1"]);
        assert_eq!(value(db, "DB_OBJ_FROM_NAME_TYPE(.m, \"m1\", \"beam\")"), Value::Nothing);
        near(db, "DB_OBJ_EXISTS_EXHAUSTIVE(.m,\"cm\") + 10*DB_OBJ_EXISTS(.m,\"cm\")", &[1.0], 0.0);
        assert_eq!(text_value(db, "DB_DEFAULT_NAME_FOR_TYPE(.m.p2.cm,\"marker\")"), "cm");
        assert_eq!(text_value(db, "UNIQUE_PARTIAL_NAME(.m,\"marker\")"), "MARKER_1");
        near(db, "DB_CHANGED()", &[1.0], 0.0);
        near(&Database::default(), "DB_CHANGED()", &[0.0], 0.0);
        near(db, "DB_ACTIVE(.m.p1.m1)", &[1.0], 0.0);
    }
    let p1 = f.p1;
    f.db.set_value(p1, "active", Value::Flag(false));
    near(&f.db, "DB_ACTIVE(.m.p1.m1) + 10*DB_ACTIVE(.m.p2.cm)", &[10.0], 0.0);
}

/// Field names may be cut to a unique beginning, also in texts (help page of EXPR_REFERENCES).
#[test]
fn field_names_may_be_cut() {
    let db = parametric().db;
    near(&db, ".m.ground.ref.loc[1] + .m.ground.ref.locati[1]", &[300.0], 0.0);
    near(&db, "EXPR_EXISTS(\"m1.loc\")", &[1.0], 0.0);
    let found = error(&db, ".m.ground.ref.locatoin");
    assert!(found.helps.iter().any(|h| h.text.contains("location")), "{found:?}");
}
