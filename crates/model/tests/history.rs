//! What is taken back, and by which names objects are found. Truth: the state before, read again.

use flexure_model::{Database, ObjectId, Value};
use schema::{Class, Dimension, Field, Group};

const GROUPS: &[Group] = &[Group {
    command: "part create",
    creates: true,
    object: "part_name",
    fields: &[Field::real("mass", Dimension::MASS)],
    rules: &[],
    doc: "",
}];
const PART: Class = Class {
    id: "part",
    word: "Part",
    families: &["body"],
    parents: &[],
    prefix: "PART_",
    statement: None,
    groups: GROUPS,
};
static BODY: Class = PART;
static OTHER: Class = Class { id: "beam", word: "Beam", families: &[], ..PART };

fn mass(database: &Database, id: ObjectId) -> Option<f64> {
    database.number(id, "mass")
}

#[test]
fn a_new_object_keeps_the_value_it_had_at_a_mark() {
    let mut database = Database::default();
    let id = database.create(&BODY, None, "a").unwrap();
    database.set_value(id, "mass", Value::Number(1.0));
    let mark = database.mark();
    database.set_value(id, "mass", Value::Number(2.0));
    database.roll_back(mark);
    assert_eq!(mass(&database, id), Some(1.0));
}

#[test]
fn a_value_set_after_the_step_of_its_object_is_a_step_of_its_own() {
    let mut database = Database::default();
    let id = database.create(&BODY, None, "a").unwrap();
    database.set_value(id, "mass", Value::Number(1.0));
    database.finish_step();
    database.set_value(id, "mass", Value::Number(2.0));
    assert!(database.undo());
    assert_eq!(mass(&database, id), Some(1.0));
    assert!(database.redo());
    assert_eq!(mass(&database, id), Some(2.0));
}

#[test]
fn an_object_comes_back_with_its_values() {
    let mut database = Database::default();
    let id = database.create(&BODY, None, "a").unwrap();
    database.set_value(id, "mass", Value::Number(1.0));
    assert!(database.undo());
    assert!(database.get(id).is_none() && database.children_named(None, "a").is_empty());
    assert!(database.redo());
    assert_eq!(mass(&database, id), Some(1.0));
}

#[test]
fn current_objects_and_the_default_frame_are_taken_back() {
    let mut database = Database::default();
    let [a, b] = ["a", "b"].map(|name| database.create(&BODY, None, name).unwrap());
    database.make_current(a);
    database.finish_step();
    database.make_current(b);
    database.set_default_frame(Some(b));
    assert!(database.undo());
    assert_eq!((database.current("part"), database.current("body")), (Some(a), Some(a)));
    assert_eq!(database.settings().default_frame, None);
    assert!(database.redo());
    assert_eq!((database.current("part"), database.settings().default_frame), (Some(b), Some(b)));
}

#[test]
fn a_name_finds_all_namesakes_whatever_the_case_and_follows_a_renaming() {
    let mut database = Database::default();
    let top = database.create(&BODY, None, "top").unwrap();
    let part = database.create(&BODY, Some(top), "Link").unwrap();
    let beam = database.create(&OTHER, Some(top), "LINK").unwrap();
    assert_eq!(database.children_named(Some(top), "link"), [part, beam]);
    assert!(database.children_named(None, "link").is_empty());
    database.rename(part, None, "rod").unwrap();
    assert_eq!(database.children_named(Some(top), "link"), [beam]);
    assert_eq!(database.children_named(None, "ROD"), [part]);
    assert_eq!(database.create(&OTHER, Some(top), "link").map_err(|taken| taken.0), Err(beam));
}

#[test]
fn holders_of_a_name_are_found_nearest_first_and_follow_every_change() {
    let mut database = Database::default();
    let [top, other] = ["top", "other"].map(|name| database.create(&BODY, None, name).unwrap());
    let arm = database.create(&BODY, Some(top), "arm").unwrap();
    let hand = database.create(&BODY, Some(arm), "hand").unwrap();
    for parent in [hand, arm, top, other] {
        database.create(&OTHER, Some(parent), "Tip").unwrap();
    }
    // A child of the root itself is not below it, and what is elsewhere is none of its business.
    assert_eq!(database.holders_of_name(top, "TIP"), [(1, arm), (2, hand)]);
    let mark = database.mark();
    let tip = database.child(Some(hand), "tip", "beam").unwrap();
    database.rename(tip, Some(arm), "nail").unwrap();
    assert_eq!(database.holders_of_name(top, "tip"), [(1, arm)]);
    assert_eq!(database.holders_of_name(top, "nail"), [(1, arm)]);
    database.roll_back(mark);
    assert_eq!(database.holders_of_name(top, "tip"), [(1, arm), (2, hand)]);
    assert!(database.holders_of_name(top, "nail").is_empty());
}
