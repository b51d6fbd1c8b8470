//! Commands that are understood but not executed stay in a model that is read and written again.

use std::path::{Path, PathBuf};

use flexure_commands::{Interpreter, OnError, Report};

const MODEL: &str = "model create model_name = car
part create rigid_body name_and_position part_name = .car.body location = 100,0,0
marker create marker_name = .car.body.m1 location = 1,0,0
marker create marker_name = .car.ground.m2 location = 0,0,0
defaults coordinate_system default_coordinate_system = .car.body
";

/// Pieces of a model, each as it must come back, with its continuation lines.
const PIECES: &[&str] = &[
    "part create external_system  &
   external_system_name = .car.BUSH_1  &
   adams_id = 7  &
! rates of the front axle
   i_marker_name = .car.body.m1  &
   j_marker_name = .car.ground.m2  &
   stiffness = 1.0E+05, 2.0E+05, (3.0E+05(newton/mm))",
    "clearance create  &
   clearance_name = .car.FM_3",
    "force attributes  &
   force_name = .car.BUSH_1  &
   visibility = off",
    "section create  section_name = .car.CUR  closed = no",
    "ude create instance  instance_name = .car.CSG_4 &
   base_object = .car.body.BOX type = union",
    "geometry attributes geometry_name = .car.CSG_4 color = RED",
    "assembly create instance instance_name = .car.CON &\n   i_geometry_name = .car.CSG_4",
];

fn session() -> Interpreter {
    let mut interpreter = Interpreter::new(elements::registry());
    interpreter.on_error = OnError::IgnoreCommand;
    interpreter
}

fn export(interpreter: &Interpreter) -> String {
    interpreter.database.current("model").map(|m| interpreter.write_model(m)).unwrap_or_default()
}

/// What was skipped, in order, but for what only concerns the display, dialogs and runs.
fn skipped(report: &Report) -> Vec<(&'static str, String)> {
    let named = report.diagnostics.iter().filter(|d| matches!(d.code, "command/not-supported" | "command/skipped-too"));
    named.filter(|d| !d.message.starts_with("`view")).map(|d| (d.code, d.message.clone())).collect()
}

fn no_errors(report: &Report) {
    assert!(!report.has_errors(), "{:#?}", report.diagnostics);
}

#[test]
fn skipped_pieces_of_a_model_are_written_as_they_were_typed() {
    let mut first = session();
    no_errors(&first.run_text("model", MODEL));
    let pieces = PIECES.join("\n!\n");
    let read = first.run_text("pieces", &format!("view zoom auto = on\n{pieces}\n!\nview erase\n"));
    no_errors(&read);
    assert_eq!(skipped(&read).len(), PIECES.len(), "{:#?}", skipped(&read));
    assert!(skipped(&read).iter().any(|(code, _)| *code == "command/skipped-too"));

    let written = export(&first);
    assert!(written.contains(&pieces), "{written}");
    assert!(!written.contains("view zoom"));
    let title = written.lines().find(|l| l.contains(" Commands that are kept but not executed ")).unwrap();
    let others = written.lines().find(|l| l.contains(" Rigid Parts ")).unwrap();
    assert_eq!(title.len(), others.len());

    let mut second = session();
    let again = second.run_text("export", &written);
    no_errors(&again);
    assert_eq!(skipped(&again), skipped(&read));
    assert_eq!(export(&second), written);
}

#[test]
fn the_units_and_the_frame_of_a_kept_command_come_back() {
    let mut first = session();
    no_errors(&first.run_text("model", MODEL));
    let piece = "part create external_system external_system_name = .car.B location = 1,2,3";
    no_errors(
        &first.run_text("piece", &format!("defaults units length = inch\n{piece}\ndefaults units length = mm\n")),
    );
    let written = export(&first);
    let (before, after) = written.split_once(piece).unwrap();
    let before = before.split_once(" kept but not ").unwrap().1;
    assert!(before.contains("length = inch") && !before.contains("length = mm"), "{written}");
    assert!(after.contains("length = mm"), "{written}");
    let frame = written.split_once(piece).unwrap().0.rsplit_once("default_coordinate_system = ").unwrap().1;
    assert!(frame.starts_with(".car.body\n"), "{written}");
    let mut second = session();
    no_errors(&second.run_text("export", &written));
    assert_eq!(export(&second), written);
}

#[test]
fn each_model_keeps_its_own_pieces_and_a_refused_command_is_not_kept() {
    let mut i = session();
    no_errors(&i.run_text("model", MODEL));
    no_errors(&i.execute(PIECES[1]));
    assert_eq!(i.execute("force attributes force_name = .car.nothing visibility = off").failed, 1);
    let first = i.database.current("model").unwrap();
    no_errors(&i.execute("model create model_name = other"));
    no_errors(&i.execute("clearance create clearance_name = .other.FM"));
    let second = i.database.current("model").unwrap();
    let (car, other) = (i.write_model(first), i.write_model(second));
    assert!(car.contains(PIECES[1]) && !car.contains(".other") && !car.contains(".car.nothing"), "{car}");
    assert!(other.contains(".other.FM") && !other.contains("FM_3"), "{other}");
}

#[test]
fn file_command_write_keeps_them_too() {
    let folder = std::env::temp_dir().join(format!("flexure-kept-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("car.cmd");
    let mut i = session();
    no_errors(&i.run_text("model", MODEL));
    no_errors(&i.execute(PIECES[0]));
    no_errors(&i.execute(&format!("file command write file_name = \"{}\"", path.display())));
    let written = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(written.contains(PIECES[0]), "{written}");
}

fn command_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for path in entries.flatten().map(|e| e.path()) {
        if path.is_dir() {
            command_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd") {
            found.push(path);
        }
    }
}

#[test]
fn the_exports_of_the_corpus_keep_all_that_was_skipped() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let mut found = Vec::new();
    command_files(&Path::new(&shared).join("corpus"), &mut found);
    found.sort();
    for path in found {
        let mut first = session();
        let read = first.run_file(&path);
        let models = first.database.roots().iter().filter(|r| first.database.object(**r).class.id == "model").count();
        if read.has_errors() || models != 1 {
            println!("{}: {models} models", path.display());
            continue;
        }
        let written = export(&first);
        let mut second = session();
        let again = second.run_text("export", &written);
        assert!(
            !again.has_errors(),
            "{}: {:#?}",
            path.display(),
            again.diagnostics.iter().filter(|d| d.is_error()).collect::<Vec<_>>()
        );
        assert_eq!(export(&second), written, "{}", path.display());
        let (had, has) = (skipped(&read), skipped(&again));
        println!("{}: {} of {} skipped commands kept", path.display(), has.len(), had.len());
        // What is left out concerns the display and dialogs.
        let mut left = has.iter().peekable();
        for command in &had {
            if left.peek().is_some_and(|next| *next == command) {
                left.next();
            } else {
                let path = command.1.trim_start_matches('`');
                let display = ["interface", "xy_plots", "animation", "simulation", "panel", "colors"];
                assert!(display.iter().any(|d| path.starts_with(d)), "{command:?}");
            }
        }
        assert!(left.next().is_none());
    }
}
