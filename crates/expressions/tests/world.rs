//! Files, clock, environment, messages: what an expression may do outside the model, and when.

mod common;
use std::{
    sync::{Arc, Mutex},
    time::Duration,
};

use common::*;
use flexure_expressions::{Bound, Scope, World, bind};
use model::{Database, Value};
use text::{Diagnostic, Sources};

fn run(db: &Database, world: &World, text: &str) -> Result<Value, Diagnostic> {
    let mut sources = Sources::default();
    let file = sources.add("t.cmd", text);
    let (tree, errors) = syntax::command::parse_expression(file, text, 0);
    assert!(errors.is_empty(), "{text}: {errors:?}");
    let scope = Scope::new(db, &sources).in_world(world);
    match bind(&tree, &scope).map_err(|e| e.into_iter().next().unwrap())? {
        Bound::Value(v) => Ok(v.value),
        Bound::Expression(e) => flexure_expressions::evaluate(&e, &scope).map(|e| e.value),
    }
}

fn integer(db: &Database, world: &World, text: &str) -> i64 {
    match run(db, world, text) {
        Ok(Value::Integer(i)) => i,
        other => panic!("{text}: {other:?}"),
    }
}

fn words(db: &Database, world: &World, text: &str) -> String {
    match run(db, world, text) {
        Ok(Value::Text(t)) => t,
        other => panic!("{text}: {other:?}"),
    }
}

/// Truth: the file system, asked by the standard library; return values as on the help pages.
#[test]
fn files_are_made_moved_and_deleted_where_that_is_allowed() {
    let (db, world) = (fixture().db, World::new(true));
    let root = std::env::temp_dir().join(format!("flexure-expressions-{}", std::process::id()));
    let place = |name: &str| root.join(name).display().to_string();
    let go = |call: String| integer(&db, &world, &call);
    assert_eq!(go(format!("MKDIR(\"{}\")", root.display())), 1);
    assert_eq!(go(format!("MKDIR(\"{}\")", root.display())), 0);
    std::fs::write(root.join("a.txt"), "abc").unwrap();
    assert_eq!(go(format!("MKDIR(\"{}\")", place("sub"))), 1);
    assert_eq!(go(format!("COPY_FILES(\"{}\",\"{}\")", place("a.txt"), place("sub"))), 1);
    assert_eq!(std::fs::read(root.join("sub/a.txt")).unwrap(), b"abc");
    assert_eq!(go(format!("COPY_FILES(\"{}\",\"{}\")", place("a.txt"), place("a.txt"))), 0);
    assert_eq!(std::fs::read(root.join("a.txt")).unwrap(), b"abc");
    assert_eq!(go(format!("RENAME_FILE(\"{}\",\"{}\")", place("a.txt"), place("b.txt"))), 0);
    assert!(go(format!("RENAME_FILE(\"{}\",\"{}\")", place("a.txt"), place("b.txt"))) != 0);
    assert_eq!(go(format!("BACKUP_FILE(\"{}\")", place("b.txt"))), 0);
    assert!(root.join("b.txt%").exists() && !root.join("b.txt").exists());
    assert_eq!(go(format!("FILE_EXISTS(\"{}\")", place("b.txt%"))), 1);
    assert_eq!(words(&db, &world, &format!("UNIQUE_FILE_NAME(\"{}\")", place("n"))), place("n_1"));
    std::fs::write(root.join("n_1"), "").unwrap();
    assert_eq!(words(&db, &world, &format!("UNIQUE_FILE_NAME(\"{}\")", place("n"))), place("n_2"));
    for file in ["b.txt%", "n_1", "sub/a.txt"] {
        assert_eq!(go(format!("REMOVE_FILE(\"{}\")", place(file))), 0);
    }
    assert!(go(format!("REMOVE_FILE(\"{}\")", place("n_1"))) != 0);
    assert_eq!(go(format!("RMDIR(\"{}\")", place("sub"))), 1);
    assert_eq!(go(format!("RMDIR(\"{}\")", root.display())), 1);
    assert!(!root.exists());
    let temporary = words(&db, &world, "FILE_TEMP_NAME()");
    assert!(!std::path::Path::new(&temporary).exists() && temporary.contains("flexure"));
}

/// A session that only checks refuses by name, and nothing happens.
#[test]
fn without_permission_nothing_outside_changes() {
    let db = fixture().db;
    let name = std::env::temp_dir().join(format!("flexure-not-made-{}", std::process::id()));
    let quoted = name.display();
    for world in [Some(World::new(false)), None] {
        for call in [
            format!("MKDIR(\"{quoted}\")"),
            format!("RMDIR(\"{quoted}\")"),
            format!("REMOVE_FILE(\"{quoted}\")"),
            format!("RENAME_FILE(\"{quoted}\",\"{quoted}2\")"),
            format!("COPY_FILES(\"/etc/hostname\",\"{quoted}\")"),
            format!("BACKUP_FILE(\"{quoted}\")"),
            format!("CHDIR(\"{quoted}\")"),
            "PUTENV(\"FLEXURE_TEST\",\"1\")".to_string(),
            "EXECUTE_VIEW_COMMAND(\"model delete model=m\")".to_string(),
        ] {
            let found = match &world {
                Some(world) => run(&db, world, &call).unwrap_err(),
                None => error(&db, &call),
            };
            let function = call.split('(').next().unwrap();
            assert_eq!(found.code, "expression/side-effect", "{call}: {}", found.message);
            assert!(found.message.contains(function), "{}", found.message);
        }
        assert!(!name.exists());
        assert!(world.is_none_or(|w| w.take_commands().is_empty()));
    }
}

/// Truth: the help pages' examples; dates by GNU `date -u -d @883967428`.
#[test]
fn clock_and_timers_come_from_the_session() {
    let time = Arc::new(Mutex::new(Duration::from_secs(883_967_428)));
    let clock = time.clone();
    let (db, world) = (fixture().db, World::new(false).with_clock(move || *clock.lock().unwrap()));
    assert_eq!(words(&db, &world, "STR_TIMESTAMP()"), "1998/01/05,02:30:28");
    assert_eq!(words(&db, &world, "STR_DATE(\"%Y %m %d, %H:%M:%S\")"), "1998 01 05, 02:30:28");
    assert_eq!(words(&db, &world, "STR_DATE(\"%Q\")"), "%Q"); // an unknown directive: the text itself
    for timer in ["TIMER_ELAPSED", "TIMER_CPU"] {
        run(&db, &world, &format!("{timer}(0)")).unwrap();
        *time.lock().unwrap() += Duration::from_millis(2500);
        assert_eq!(run(&db, &world, &format!("{timer}(1)")).unwrap(), Value::Number(2.5), "{timer}");
    }
}

/// Truth: the help pages of ALERT (the default button), STR_PRINT, STATUS_PRINT.
#[test]
fn messages_go_to_the_session() {
    let (db, world) = (fixture().db, World::new(false));
    assert_eq!(integer(&db, &world, "ALERT(\"Information\",\"Create a test?\",\"Yes\",\"No\",\"Cancel\",2)"), 2);
    assert_eq!(integer(&db, &world, "ALERT(\"warning\",\"Go on?\",\"Yes\",\"No\",2)"), 2);
    assert_eq!(integer(&db, &world, "ALERT2({\"Out of\",\"disk\"},\"ERROR\")"), 1);
    assert_eq!(integer(&db, &world, "ALERT3({\"Out of\",\"disk\"},\"ERROR\",\"OK\",\"Cancel\",\"\",1)"), 1);
    run(&db, &world, "STR_PRINT(\"My variable is \" // 45)").unwrap();
    assert_eq!(words(&db, &world, "STATUS_PRINT(\"List\")"), "List");
    assert_eq!(
        world.take_printed(),
        [
            "Information: Create a test?",
            "warning: Go on?",
            "ERROR: Out of",
            "ERROR: disk",
            "ERROR: Out of",
            "ERROR: disk",
            "My variable is 45",
            "List"
        ]
    );
    assert!(run(&db, &world, "ALERT(\"e\",\"t\",\"a\",\"b\",\"c\",4)").unwrap_err().message.contains("3 buttons"));
}

#[test]
fn environment_and_commands_belong_to_the_session() {
    let (db, world) = (fixture().db, World::new(true));
    assert_eq!(integer(&db, &world, "PUTENV(\"FLEXURE_TEST_X\",\"X11\")"), 0);
    assert_eq!(words(&db, &world, "GETENV(\"FLEXURE_TEST_X\")"), "X11");
    assert_eq!(words(&db, &World::new(true), "GETENV(\"FLEXURE_TEST_X\")"), "");
    assert!(integer(&db, &world, "PUTENV(\"A=B\",\"1\")") != 0);
    let command = "EXECUTE_VIEW_COMMAND(\"marker create marker=\" // UNIQUE_NAME(\"mar\"))";
    assert_eq!(integer(&db, &world, command), 1);
    assert_eq!(world.take_commands(), ["marker create marker=mar_1"]);
}

/// Truth: the first two numbers of SplitMix64 from seed 0 are 0xe220a8397b1dcdaf and
/// 0x6e789e6aa1b965f4 (reference implementation of Vigna); the upper 53 bits over 2**53 - 1.
#[test]
fn random_numbers_repeat_from_session_to_session() {
    let db = fixture().db;
    let expected =
        [0xe220_a839_7b1d_cdaf_u64, 0x6e78_9e6a_a1b9_65f4].map(|x| (x >> 11) as f64 / 9_007_199_254_740_991.0);
    for _ in 0..2 {
        let world = World::new(false);
        for x in expected {
            assert_eq!(run(&db, &world, "RAND()").unwrap(), Value::Number(x));
        }
        let mean = (0..2000).map(|_| run(&db, &world, "RAND()").unwrap().as_number().unwrap()).sum::<f64>() / 2000.0;
        assert!((mean - 0.5).abs() < 0.03, "{mean}"); // 0.29 / sqrt(2000) = 0.0065, four times that
    }
}

/// Truth: help pages' examples.
#[test]
fn file_names_are_taken_apart() {
    let db = fixture().db;
    for (call, expected) in [
        ("FILE_DIRECTORY_NAME(\"my_dir/my_file.dat\")", "my_dir"),
        ("FILE_DIRECTORY_NAME(\"my_file.dat\")", ""),
        ("FILE_DIRECTORY_NAME(\"/x\")", "/"),
        ("FILE_MINUS_EXT(\"my_file.dat\")", "my_file"),
        ("FILE_MINUS_EXT(\"a.b/my_file\")", "a.b/my_file"),
        ("FILE_MINUS_EXT(\"a.b/.my\")", "a.b/.my"),
    ] {
        assert_eq!(text_value(&db, call), expected, "{call}");
    }
    assert_eq!(text_value(&db, "SYS_INFO(\"UID\")").parse::<u32>().is_ok(), cfg!(target_os = "linux"));
}
