//! What expressions see and do beyond the cells they name: the tree of objects, messages, files,
//! commands.

use flexure_commands::{Interpreter, OnError, Report};

fn session() -> Interpreter {
    let mut i = Interpreter::new(elements::registry());
    i.on_error = OnError::IgnoreCommand;
    good(&mut i, "model create model_name = m");
    good(&mut i, "part create rigid_body name_and_position part_name = .m.p");
    i
}

fn good(i: &mut Interpreter, text: &str) -> Report {
    let report = i.execute(text);
    assert!(!report.has_errors(), "{text}: {:?}", report.diagnostics);
    report
}

fn number(i: &Interpreter, name: &str) -> Option<f64> {
    i.database.number(i.database.find(name, "any")?, "real_value")
}

/// Truth: counted by hand. What depends on the count follows, and undo takes both back.
#[test]
fn a_count_of_objects_follows_the_commands() {
    let mut i = session();
    good(&mut i, "variable create variable_name = .m.n real_value = (DB_OBJECT_COUNT(DB_CHILDREN(.m.p, \"marker\")))");
    good(&mut i, "variable create variable_name = .m.twice real_value = (2 * .m.n)");
    let before = number(&i, ".m.n").unwrap();
    good(&mut i, "marker create marker_name = .m.p.a\nmarker create marker_name = .m.p.b");
    assert_eq!((number(&i, ".m.n"), number(&i, ".m.twice")), (Some(before + 2.0), Some(2.0 * before + 4.0)));
    good(&mut i, "marker delete marker_name = .m.p.a");
    assert_eq!((number(&i, ".m.n"), number(&i, ".m.twice")), (Some(before + 1.0), Some(2.0 * before + 2.0)));
    good(&mut i, "undo backward");
    assert_eq!((number(&i, ".m.n"), number(&i, ".m.twice")), (Some(before + 2.0), Some(2.0 * before + 4.0)));
}

/// A cell that asked an object which is gone keeps its value, and the command that deleted goes on.
#[test]
fn a_question_without_an_answer_is_reported_once() {
    let mut i = session();
    good(&mut i, "marker create marker_name = .m.p.a");
    good(&mut i, "variable create variable_name = .m.t real_value = (DB_EXISTS(\".m.p.a\"))");
    good(&mut i, "marker delete marker_name = .m.p.a");
    assert_eq!(number(&i, ".m.t"), Some(0.0));
}

#[test]
fn messages_are_notes_and_commands_run_afterwards() {
    let mut i = session();
    let report = good(&mut i, "variable set variable_name = .m.x integer_value = (eval(STR_PRINT(\"at \" // 3)))");
    assert!(report.diagnostics.iter().any(|d| d.code == "expression/printed" && d.message == "at 3"), "{report:?}");
    let ask = "variable set variable_name = .m.ok integer_value = (eval(EXECUTE_VIEW_COMMAND(\"marker create marker=.m.p.made\")))";
    let refused = i.execute(ask);
    assert!(refused.diagnostics.iter().any(|d| d.code == "expression/side-effect"), "{refused:?}");
    assert!(i.database.find(".m.p.made", "marker").is_none());
    i.world.allows_changes = true;
    good(&mut i, ask);
    assert!(i.database.find(".m.p.made", "marker").is_some());
}

/// A session that only looks makes no folder; one that may makes it once.
#[test]
fn folders_are_made_where_that_is_allowed() {
    let folder = std::env::temp_dir().join(format!("flexure-commands-{}", std::process::id()));
    let command =
        format!("variable set variable_name = .m.made integer_value = (eval(MKDIR(\"{}\")))", folder.display());
    let mut i = session();
    assert!(i.execute(&command).has_errors() && !folder.exists());
    i.world.allows_changes = true;
    good(&mut i, &command);
    assert!(folder.exists());
    let made = i.database.find(".m.made", "variable").unwrap();
    assert_eq!(i.database.integer(made, "integer_value"), Some(1));
    std::fs::remove_dir(folder).unwrap();
}

/// Types that no object has yet are known from the registry.
#[test]
fn fields_of_any_type_are_known() {
    let mut i = session();
    good(&mut i, "variable set variable_name = .m.f string_value = (eval(DB_TYPE_FIELDS(\"beam\")))");
    let fields = i.database.find(".m.f", "variable").unwrap();
    let text = format!("{:?}", i.database.value(fields, "string_value"));
    assert!(text.contains("youngs_modulus"), "{text}");
}
