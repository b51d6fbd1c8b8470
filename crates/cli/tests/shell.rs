//! The command window from outside: what is typed through a pipe, what is shown, what is kept.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin;
use tempfile::TempDir;

/// Runs the program with text on standard input; returns exit status, standard output and error.
fn run(folder: &TempDir, arguments: &[&str], input: &str) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments);
    let output = command.write_stdin(input).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

fn export(folder: &TempDir, file: &str) -> String {
    let (status, _, errors) = run(folder, &["convert", file, "exported.cmd"], "");
    assert_eq!(status, 0, "{errors}");
    fs::read_to_string(folder.path().join("exported.cmd")).unwrap()
}

const TYPED: &str = "\
model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 1,0,0
marker create &
  marker_name = .m.p.a &
  ! aside
  location = 1,2,3
variable set variable_name = n real_value = 3
for variable_name = k start_value = 1 end_value = 5
  if condition = (k > n)
    break
  end

  marker create marker_name = (eval(\".m.p.k\" // RTOI(k))) location = (eval(k)), 0, 0
end
";

#[test]
fn commands_are_executed_one_by_one_and_lists_are_shown() {
    let folder = TempDir::new().unwrap();
    let list = "list_info marker marker_name = .m.p.late";
    let input = format!("{TYPED}marker create marker_name = .m.p.late\nundo\n{list}\nredo\n{list}\nmodel verify");
    let (status, shown, errors) = run(&folder, &["shell"], &input);
    assert_eq!(errors.matches("error[name/not-found]").count(), 1, "taken back, then done again: {errors}");
    assert_eq!(shown.matches("Object Name     : .m.p.late").count(), 1, "{shown}");
    assert!(shown.contains("Gruebler Count"), "{shown}");
    assert!(!shown.contains('>') && !shown.contains("Enter a command"), "a pipe is not prompted: {shown}");
    assert_eq!(status, 1, "one command failed");
}

#[test]
fn the_end_of_input_and_quit_leave_and_the_status_tells() {
    let folder = TempDir::new().unwrap();
    assert_eq!(run(&folder, &["shell"], TYPED).0, 0);
    let (status, shown, _) = run(&folder, &["shell"], "quit\nlist_info model");
    assert_eq!((status, shown.as_str()), (0, ""));
    let (status, _, errors) = run(&folder, &["shell"], "marker creat");
    assert!(status == 1 && errors.contains("error["), "{errors}");
    // A block without end is executed as at the end of a file.
    let (_, _, errors) = run(&folder, &["shell"], "if condition = (1)\nmodel create model_name = q\nlist_info model\n");
    assert!(errors.contains("command/unclosed-block"), "{errors}");
}

#[test]
fn questions_and_help_are_answered_and_change_nothing() {
    let folder = TempDir::new().unwrap();
    let input = format!(
        "{TYPED}marker modify ?\nmarker delete marker_name = ?\nmarker create &\n ?\n marker_name = .m.p.z\nhelp undo\nhelp marker create\n?\n"
    );
    let (status, shown, errors) = run(&folder, &["shell", "--save", "m.fx"], &input);
    assert_eq!(status, 0, "{errors}");
    assert!(shown.contains("  new_marker_name ") && shown.contains("  backward "), "{shown}");
    assert!(shown.contains("\n  k3  Marker, the current one\n"), "{shown}");
    assert!(export(&folder, "m.fx").contains(".m.p.z"));
}

#[test]
fn a_fx_file_is_made_followed_and_read_everywhere() {
    let folder = TempDir::new().unwrap();
    let (status, _, errors) = run(&folder, &["shell", "m.fx"], TYPED);
    assert_eq!(status, 0, "{errors}");
    let (status, _, errors) = run(&folder, &["shell", "m.fx"], "marker create marker_name = .m.p.second\nundo\nredo\n");
    assert_eq!(status, 0, "{errors}");
    let first = export(&folder, "m.fx");
    assert!(first.contains(".m.p.k3") && first.contains(".m.p.second"), "{first}");
    // Twin: the same model by way of a command file.
    fs::write(folder.path().join("m.cmd"), &first).unwrap();
    assert_eq!(run(&folder, &["convert", "m.cmd", "again.fx"], "").0, 0);
    assert_eq!(export(&folder, "again.fx"), export(&folder, "m.cmd"));
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/cantilever/cantilever.cmd");
    fs::copy(example, folder.path().join("c.cmd")).unwrap();
    assert_eq!(run(&folder, &["convert", "c.cmd", "c.fx"], "").0, 0);
    let outputs = |file: &str| {
        let verified = run(&folder, &["verify", file], "");
        let drawn = run(&folder, &["plot", file, "-o", "model.svg", "--title", "t"], "").0;
        let solved = run(&folder, &["simulate", file, "--static", "--out", "r.csv"], "").0;
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
        (verified, drawn, solved, read("model.svg"), read("r.csv"))
    };
    assert_eq!(outputs("c.fx"), outputs("c.cmd"));
    let (status, _, errors) = run(&folder, &["shell", "m.cmd", "--save", "m.fx"], "");
    assert!(status == 1 && errors.contains("--overwrite"), "{errors}");
    assert_eq!(run(&folder, &["shell", "m.cmd", "--save", "m.fx", "--overwrite"], "").0, 0);
}

#[test]
fn a_damaged_file_is_refused() {
    let folder = TempDir::new().unwrap();
    run(&folder, &["shell", "m.fx"], TYPED);
    let bytes = fs::read(folder.path().join("m.fx")).unwrap();
    fs::write(folder.path().join("m.fx"), &bytes[..bytes.len() / 2]).unwrap();
    for arguments in [&["shell", "m.fx"][..], &["verify", "m.fx"], &["convert", "m.fx", "x.cmd"]] {
        let (status, _, errors) = run(&folder, arguments, "");
        assert!(status == 1 && errors.contains("error[store/damaged]"), "{arguments:?}: {errors}");
    }
}

/// A window that is being typed in.
struct Open {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Open {
    fn new(folder: &TempDir, arguments: &[&str]) -> Open {
        let mut child = std::process::Command::new(cargo_bin("flexure"))
            .current_dir(folder.path())
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (input, output) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
        Open { child, input, output }
    }

    fn say(&mut self, line: &str) {
        writeln!(self.input, "{line}").unwrap();
    }

    /// Waits until a listing begins with this text: all that was said before is done.
    fn wait_for(&mut self, text: &str) {
        let mut line = String::new();
        while !line.contains(text) {
            line.clear();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "`{text}` is not shown");
        }
    }
}

#[test]
fn a_killed_window_loses_nothing_it_has_shown() {
    let folder = TempDir::new().unwrap();
    run(&folder, &["shell", "m.fx"], "model create model_name = m");
    for round in 0..4 {
        let mut window = Open::new(&folder, &["shell", "m.fx"]);
        for number in 0..6 {
            window.say(&format!("marker create marker_name = .m.ground.k{round}_{number}"));
            window.say(&format!("list_info marker marker_name = .m.ground.k{round}_{number}"));
        }
        window.wait_for(&format!(".m.ground.k{round}_{}", 2 + round));
        window.child.kill().unwrap();
        window.child.wait().unwrap();
        let kept = export(&folder, "m.fx");
        for number in 0..=2 + round {
            assert!(kept.contains(&format!(".m.ground.k{round}_{number}")), "{round} {number} is lost");
        }
    }
}

#[test]
fn a_second_window_is_told_at_once_and_may_look() {
    let folder = TempDir::new().unwrap();
    let mut first = Open::new(&folder, &["shell", "m.fx"]);
    first.say("model create model_name = m\nlist_info model model_name = m");
    first.wait_for("Object Name     : .m");
    let (status, _, errors) = run(&folder, &["shell", "m.fx"], "");
    let holder = format!("in use by process {}", first.child.id());
    assert!(status == 1 && errors.contains("store/in-use") && errors.contains(&holder), "{errors}");
    let (status, shown, errors) = run(&folder, &["shell", "m.fx", "--read-only"], "list_info model model_name = m\n");
    assert!(status == 0 && shown.contains("Object Name     : .m"), "{shown}{errors}");
    drop(first.input);
    assert!(first.child.wait().unwrap().success());
    assert_eq!(run(&folder, &["shell", "m.fx"], "").0, 0);
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_a_piped_window_with_its_status_and_keeps_what_was_done() {
    let folder = TempDir::new().unwrap();
    let mut window = Open::new(&folder, &["shell", "m.fx"]);
    window.say("model create model_name = m\nlist_info model model_name = m");
    window.wait_for("Object Name");
    window.say("while condition = (1)\nundo set steps_stored = 5\nend");
    let sent = std::process::Command::new("kill").args(["-INT", &window.child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(window.child.wait().unwrap().code(), Some(130));
    assert!(export(&folder, "m.fx").contains("model_name = m"));
}

/// Twin: the session that wrote the journal, saved in a file.
#[test]
fn a_journal_builds_the_same_model() {
    let folder = TempDir::new().unwrap();
    let typed = format!(
        "{TYPED}marker create marker_name = .m.p.a\nmarker creat\nundo\nredo\nmarker delete marker_name = .m.p.k2\nundo\nview erase\nhelp marker\n?\nlist_info model\nentity modify entity_name = .m.p.a new_entity_name = renamed\n"
    );
    let (status, _, _) = run(&folder, &["shell", "m.fx", "--journal", "aview.log"], &typed);
    assert_eq!(status, 1);
    let wanted = export(&folder, "m.fx");
    assert!(wanted.contains(".m.p.renamed") && wanted.contains(".m.p.k2"));
    let journal = fs::read_to_string(folder.path().join("aview.log")).unwrap();
    assert!(journal.contains("! ERROR:"), "mistakes are on record: {journal}");
    let (status, _, errors) = run(&folder, &["shell", "replayed.fx"], &journal);
    assert_eq!(status, 0, "{errors}");
    assert_eq!(export(&folder, "replayed.fx"), wanted);
    fs::rename(folder.path().join("aview.log"), folder.path().join("log.cmd")).unwrap();
    assert_eq!(export(&folder, "log.cmd"), wanted);
}

/// A file that was read is where history begins, and every step says what it did.
#[test]
fn undo_stops_at_the_file_that_was_read_and_says_what_it_takes_back() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("m.cmd"), "model create model_name = m\nmarker create marker_name = .m.ground.a\n")
        .unwrap();
    let input = "undo\nmarker create marker_name = .m.ground.b\nundo\nredo\n\
                 marker modify marker_name = .m.ground.a location = 1,2,3\nundo\nundo\nundo\n\
                 list_info marker marker_name = .m.ground.a\n";
    let (status, shown, errors) = run(&folder, &["shell", "m.cmd"], input);
    assert_eq!((status, errors.matches("error[undo/nothing]").count()), (1, 2), "{errors}");
    let said: Vec<&str> = shown.lines().filter(|l| l.contains("taken back") || l.contains("done again")).collect();
    assert_eq!(
        said,
        [
            "taken back: `.m.ground.b` is gone",
            "done again: `.m.ground.b` is there",
            "taken back: `.m.ground.a` is changed",
            "taken back: `.m.ground.b` is gone",
        ]
    );
    assert!(shown.contains("Object Name     : .m.ground.a"), "{shown}");
}

/// A loop that is not closed holds what follows; whoever wants to leave is told.
#[test]
fn quit_within_an_open_block_says_that_it_is_open() {
    let folder = TempDir::new().unwrap();
    let (_, _, errors) = run(&folder, &["shell"], "for variable_name = k start_value = 1 end_value = 2\nquit\n");
    assert!(errors.contains("`for` is open and `quit` belongs to it: `end` closes it"), "{errors}");
}
