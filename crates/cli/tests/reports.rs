//! What is said where: help, counts, listings, partial results, and streams that take nothing.

use std::fs;
use std::io::Read;
use std::process::Stdio;

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin;
use tempfile::TempDir;

/// A pendulum.
const SCENE: &str = "\
defaults units length=mm angle=deg force=newton mass=kg time=sec
model create model_name = m
part create rigid_body name_and_position part_name = .m.a location = 0,0,0
marker create marker_name = .m.a.cm location = 0,0,0 relative_to = .m.a
marker create marker_name = .m.a.j location = -100,0,0 relative_to = .m.a
part create rigid_body mass_properties part_name=.m.a mass=1 center_of_mass_marker=.m.a.cm ixx=1 iyy=1 izz=1
marker create marker_name = .m.ground.r location = -100,0,0 relative_to = .m.ground
constraint create joint revolute joint_name = .m.pin i_marker_name = .m.a.j j_marker_name = .m.ground.r
";
/// A beam with shear ratios that its formulation leaves aside, which is worth a note.
const NOTED: &str = "\
force create element_like beam beam_name=.m.b i_marker_name=.m.a.cm j_marker_name=.m.ground.r length=100 ixx=4 iyy=2 izz=2 &
   area_of_cross_section=2 y_shear_area_ratio=1.2 z_shear_area_ratio=1.2 youngs_modulus=5 shear_modulus=2 &
   damping_ratio=0 formulation=nonlinear
";

fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let output = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// Words of a text, whatever its lines are.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_help_of_a_subcommand_begins_with_what_it_does() {
    let folder = folder(&[]);
    let (_, all, _) = run(&folder, &["--help"]);
    let list = all.split_once("Commands:\n").unwrap().1.split_once("\nOptions:").unwrap().0;
    // The list: a name, two blanks or more, a sentence that goes on in lines without a name.
    let mut commands: Vec<(String, String)> = Vec::new();
    for line in list.lines().filter(|line| !line.trim().is_empty()) {
        match line.strip_prefix("  ").filter(|rest| !rest.starts_with(' ')) {
            Some(rest) => {
                let (name, sentence) = rest.split_once(' ').unwrap();
                commands.push((name.into(), sentence.into()));
            }
            None => commands.last_mut().unwrap().1 += line,
        }
    }
    commands.retain(|(name, _)| name != "help");
    assert!(commands.len() >= 13, "{commands:?}");
    for (name, sentence) in commands {
        for flag in ["-h", "--help"] {
            let (_, help, _) = run(&folder, &[&name, flag]);
            assert!(words(&help).starts_with(&words(&sentence)), "{name} {flag}: {sentence}\n{help}");
        }
    }
}

#[test]
fn notes_are_no_warnings() {
    let commands = "list_info marker marker_name = .m.a.*\n";
    let folder = folder(&[("m.cmd", &format!("{SCENE}{commands}")), ("noted.cmd", &format!("{SCENE}{NOTED}"))]);
    let (status, _, errors) = run(&folder, &["run", "--strict", "m.cmd"]);
    assert!(errors.contains("note["), "{errors}");
    assert!(errors.ends_with("9 commands executed, 0 errors, 0 warnings, 1 note\n"), "{errors}");
    assert_eq!(status, 0, "{errors}");
    let (status, _, errors) = run(&folder, &["check", "m.cmd"]);
    assert_eq!((status, errors.lines().last()), (0, Some("0 errors, 0 warnings, 1 note")), "{errors}");
    let (_, report, _) = run(&folder, &["check", "m.cmd", "--format", "json"]);
    for count in ["\"errors\": 0", "\"warnings\": 0", "\"notes\": 1"] {
        assert!(report.contains(count), "{count}: {report}");
    }
    let (status, _, errors) = run(&folder, &["verify", "noted.cmd"]);
    assert!(errors.contains("0 findings and 1 note, "), "{errors}");
    assert_eq!(status, 0, "{errors}");
}

#[test]
fn listings_go_where_results_go() {
    let folder = folder(&[("m.cmd", &format!("{SCENE}list_info marker marker_name = .m.a.cm\n"))]);
    let (status, shown, errors) = run(&folder, &["run", "m.cmd"]);
    assert_eq!(status, 0, "{errors}");
    assert!(shown.contains("Object Name     : .m.a.cm"), "{shown}");
    assert!(!errors.contains("Object Name"), "{errors}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_told_in_a_sentence() {
    let folder = folder(&[("m.cmd", SCENE)]);
    for arguments in
        [&["check", "m.cmd", "--format", "json"][..], &["section", "circle", "--diameter", "3"], &["--help"]]
    {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut command = std::process::Command::new(cargo_bin("flexure"));
        let child = command.current_dir(folder.path()).args(arguments).stdout(full).stderr(Stdio::piped()).output();
        let output = child.unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{errors}");
        assert!(errors.starts_with("flexure: cannot write standard output: No space left on device"), "{errors}");
        assert_eq!(errors.lines().count(), 1, "{errors}");
    }
}

/// Interrupts a run of one of the doors when it has begun to write; returns all it said and its status.
#[cfg(unix)]
fn interrupted(folder: &TempDir, arguments: &[&str], input: &str, file: &str) -> (i32, String, String) {
    use std::io::Write;
    let mut command = std::process::Command::new(cargo_bin("flexure"));
    command.current_dir(folder.path()).args(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(input.as_bytes()).unwrap();
    let path = folder.path().join(file);
    for _ in 0..600 {
        if fs::metadata(&path).is_ok_and(|data| data.len() > 0) {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let (mut shown, mut errors) = (String::new(), String::new());
    child.stderr.take().unwrap().read_to_string(&mut errors).unwrap();
    child.stdout.take().unwrap().read_to_string(&mut shown).unwrap();
    drop(stdin);
    (child.wait().unwrap().code().unwrap_or(-1), shown, errors)
}

#[test]
#[cfg(unix)]
fn an_interrupted_run_says_how_far_its_file_goes() {
    let endless = "simulation single_run transient type = auto_select end_time = 1e5 number_of_steps = 5000000\n";
    let folder = folder(&[("long.cmd", &format!("{SCENE}{endless}")), ("m.cmd", SCENE)]);
    let simulate = ["simulate", "m.cmd", "--end", "1e5", "--steps", "5000000", "--out", "one.csv"];
    let ways: [(&[&str], &str, &str); 3] = [
        (&["run", "long.cmd"], "", "m_1_dynamic.csv"),
        (&simulate, "", "one.csv"),
        (&["shell", "m.cmd", "--out", "shell"], endless, "shell/m_1_dynamic.csv"),
    ];
    for (arguments, input, file) in ways {
        let (status, shown, errors) = interrupted(&folder, arguments, input, file);
        assert_eq!(status, 130, "{arguments:?}: {errors}");
        let line = errors.lines().find(|line| line.contains("stopped at ")).unwrap_or_else(|| panic!("{errors}"));
        let time = line.split_once("stopped at ").unwrap().1.split_once(" s; ").unwrap().0;
        let results = fs::read_to_string(folder.path().join(file)).unwrap();
        let last = results.lines().last().unwrap().split(',').next().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        assert!((number(last) - number(time)).abs() <= 1e-9 * number(time), "{line}: {last}");
        assert!(shown.lines().any(|path| path.ends_with(file)), "{shown}");
        if arguments[0] == "run" {
            assert!(errors.ends_with("; stopped by Ctrl-C\n"), "{errors}");
        }
    }
}

#[test]
fn a_run_without_output_leaves_no_file_and_warns_once() {
    // The force is not defined at the start.
    let fails = "force create direct single_component_force single_component_force_name = .m.f &
   type_of_freedom = translational i_marker_name = .m.a.cm j_marker_name = .m.ground.r action_only = on &
   function = \"sqrt(-1-time)\"
simulation single_run transient type = auto_select end_time = 1 number_of_steps = 10
";
    let folder = folder(&[
        ("bad.cmd", &format!("{SCENE}{fails}")),
        ("m.cmd", &format!("{SCENE}{}", fails.split_once("simulation").unwrap().0)),
    ]);
    let (status, shown, errors) = run(&folder, &["run", "bad.cmd"]);
    assert_eq!((status, shown.as_str()), (1, ""), "{errors}");
    assert!(errors.contains("no output was reached; ./m_1_dynamic.csv is not written"), "{errors}");
    assert!(!folder.path().join("m_1_dynamic.csv").exists());
    assert_eq!(errors.matches("output/everything").count(), 1, "{errors}");
    let (status, shown, errors) = run(&folder, &["simulate", "m.cmd", "--end", "1", "--out", "one.parquet"]);
    assert_eq!((status, shown.as_str()), (1, ""), "{errors}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "{errors}");
}

#[test]
fn other_models_are_named_where_one_is_taken() {
    let folder = folder(&[("two.cmd", "model create model_name = a\nmodel create model_name = b\n")]);
    let (status, _, errors) = run(&folder, &["convert", "two.cmd", "out.cmd"]);
    assert_eq!(status, 0, "{errors}");
    assert!(errors.contains("warning[file/other-models]: out.cmd does not hold .a"), "{errors}");
    let (_, _, errors) = run(&folder, &["convert", "two.cmd", "out.fx"]);
    assert_eq!(errors, "", "a store holds both");
    let (_, _, errors) = run(&folder, &["convert", "out.cmd", "again.cmd"]);
    assert_eq!(errors, "", "one model is all");
    let (_, _, errors) = run(&folder, &["verify", "two.cmd"]);
    assert!(errors.contains("warning: only `.b`, the current model, is verified, not .a"), "{errors}");
    let (_, _, errors) = run(&folder, &["diff", "two.cmd", "out.cmd"]);
    assert_eq!(
        errors.matches("warning: only `.b`, the current model, is compared of two.cmd, not .a").count(),
        1,
        "{errors}"
    );
}

#[test]
fn a_section_says_what_it_lacks() {
    let folder = folder(&[]);
    let refused = |arguments: &[&str]| {
        let (status, shown, errors) = run(&folder, &[&["section"], arguments].concat());
        assert_eq!((status, shown.as_str()), (2, ""), "{errors}");
        errors
    };
    assert_eq!(refused(&["circle"]), "flexure: a section `circle` needs --diameter\n");
    assert!(refused(&["tube", "--diameter", "3"]).contains("needs --thickness; its sizes are --diameter, --thickness"));
    assert!(refused(&["circle", "--diameter", "3", "--units", "furlong"]).contains("`furlong` is no unit of length"));
    assert!(refused(&["circle", "--diameter", "3", "--units", "kg"]).contains("`kg` is no unit of length"));
    for size in ["1e200", "1e-200"] {
        let errors = refused(&["rectangle", "--width", size, "--height", "1"]);
        assert!(errors.contains("the sizes are too"), "{errors}");
    }
    assert_eq!(run(&folder, &["section", "circle", "--diameter", "3", "--units", "inch"]).0, 0);
}

/// Truth: the answer to the prompt of line 9 is line 10.
#[test]
fn a_wrong_answer_to_a_prompt_is_shown_in_its_file() {
    let prompt = "force create element_like beam beam_name = .m.b i_marker_name = .m.a.cm\n  .m.ground.nothing\n";
    let folder = folder(&[("a.cmd", &format!("{SCENE}{prompt}"))]);
    let (status, report, _) = run(&folder, &["check", "a.cmd", "--format", "github"]);
    assert_eq!(status, 1, "{report}");
    assert!(report.contains("file=a.cmd,line=10,endLine=10,col=3,"), "{report}");
    assert!(!report.contains("with the answer"), "{report}");
}
