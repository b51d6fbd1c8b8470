//! `fmt`, `check --fix` and `diff` from outside: what is printed, what is written, how they exit.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

const MODEL: &str = "\
defaults units  length = mm  angle = deg  force = newton  mass = kg  time = sec
model create model_name = m
part create rigid_body name_and_position  part_name = .m.a  location = 0, 0, 0
marker create  marker_name = .m.a.cm  location = 0, 0, 0  relative_to = .m.a
marker create  marker_name = .m.ground.r  location = -100, 0, 0  relative_to = .m.ground
force create element_like beam  &
   beam_name = .m.b  &
   i_marker_name = .m.a.cm  &
   j_marker_name = .m.ground.r  &
   length = 100
";

/// Runs the program in a folder; returns exit status, standard output and standard error.
fn run(folder: &TempDir, arguments: &[&str], input: &str) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let command = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).write_stdin(input);
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

fn put(folder: &TempDir, name: &str, text: impl AsRef<[u8]>) {
    fs::write(folder.path().join(name), text).unwrap();
}

fn written(folder: &TempDir, name: &str) -> String {
    String::from_utf8_lossy(&fs::read(folder.path().join(name)).unwrap()).into_owned()
}

#[test]
fn fmt_writes_the_layout_and_says_with_check_what_would_change() {
    let folder = TempDir::new().unwrap();
    put(&folder, "good.cmd", MODEL);
    put(&folder, "bad.cmd", "model   create model_name=m ! first\n\n\n\nundo");
    let (status, out, _) = run(&folder, &["fmt", "--check", "good.cmd", "bad.cmd"], "");
    assert_eq!((status, out.as_str()), (1, "bad.cmd\n"));
    let (status, out, _) = run(&folder, &["fmt", "--diff", "bad.cmd"], "");
    assert_eq!(status, 1);
    assert!(out.contains("-model   create model_name=m ! first\n+model create model_name = m  ! first\n"), "{out}");
    assert!(written(&folder, "bad.cmd").starts_with("model   create"), "looking changes nothing");
    let (status, out, errors) = run(&folder, &["fmt", "good.cmd", "bad.cmd"], "");
    assert_eq!((status, out.as_str(), errors.as_str()), (0, "", ""));
    assert_eq!(written(&folder, "bad.cmd"), "model create model_name = m  ! first\n\nundo\n");
    assert_eq!(run(&folder, &["fmt", "--check", "good.cmd", "bad.cmd"], "").0, 0);
}

#[test]
fn fmt_filters_standard_input() {
    let folder = TempDir::new().unwrap();
    let (status, out, _) = run(&folder, &["fmt", "-"], "undo   end_block");
    assert_eq!((status, out.as_str()), (0, "undo end_block\n"));
}

#[test]
fn fmt_leaves_what_it_does_not_understand_and_names_it() {
    let folder = TempDir::new().unwrap();
    let text = "model   create comments = \"open\nundo   end_block\n";
    put(&folder, "broken.cmd", text);
    let (status, _, errors) = run(&folder, &["fmt", "broken.cmd"], "");
    assert_eq!(status, 1);
    assert!(errors.contains("error[syntax/unclosed-quote]") && errors.contains("broken.cmd:1:"), "{errors}");
    assert_eq!(written(&folder, "broken.cmd"), "model   create comments = \"open\nundo end_block\n");
    assert_eq!(run(&folder, &["fmt", "absent.cmd"], "").0, 1);
}

/// A comment of an old file in code page 1252 comes back byte for byte.
#[test]
fn fmt_keeps_the_encoding() {
    let folder = TempDir::new().unwrap();
    put(&folder, "old.cmd", b"model   create ! L\xe4nge \x80\x81\n");
    assert_eq!(run(&folder, &["fmt", "old.cmd"], "").0, 0);
    assert_eq!(fs::read(folder.path().join("old.cmd")).unwrap(), b"model create  ! L\xe4nge \x80\x81\n");
}

#[test]
fn check_with_fix_mends_what_is_certain() {
    let folder = TempDir::new().unwrap();
    let wrong = MODEL
        .replace("marker create  marker_name = .m.a.cm", "marker creaet  marker_nme = .m.a.cm")
        .replace("time = sec", "time = secnod")
        .replace("i_marker_name = .m.a.cm  &", "i_marker_name = .m.a.cmm")
        .replace("length = 100", "lenght = 100");
    put(&folder, "wrong.cmd", &wrong);
    let (status, _, errors) = run(&folder, &["check", "wrong.cmd"], "");
    assert_eq!(status, 1, "{errors}");
    assert_eq!(written(&folder, "wrong.cmd"), wrong);
    let (status, out, _) = run(&folder, &["check", "--fix", "--diff", "wrong.cmd"], "");
    assert_eq!(status, 0, "what is left after mending: {out}");
    assert!(out.contains("-   lenght = 100\n+   length = 100\n"), "{out}");
    assert_eq!(written(&folder, "wrong.cmd"), wrong, "--diff writes nothing");
    let (status, out, errors) = run(&folder, &["check", "--fix", "wrong.cmd"], "");
    assert_eq!((status, out.as_str()), (0, ""), "{errors}");
    assert!(errors.contains("`lenght` becomes `length`"), "{errors}");
    let right = MODEL.replace("time = sec\n", "time = second\n");
    assert_eq!(written(&folder, "wrong.cmd"), right);
    // Standard input is mended to standard output.
    let (status, out, _) = run(&folder, &["check", "--fix", "-"], &wrong);
    assert_eq!((status, out), (0, right));
}

#[test]
fn check_with_fix_leaves_what_is_not_certain() {
    let folder = TempDir::new().unwrap();
    let text = format!("{MODEL}force modify element_like beam beam_name = .m.b ixy = 3\nwhatever 3\n");
    put(&folder, "odd.cmd", &text);
    let (status, _, errors) = run(&folder, &["check", "--fix", "odd.cmd"], "");
    assert_eq!(status, 1, "{errors}");
    assert_eq!(written(&folder, "odd.cmd"), text);
}

/// Commands that write, run programs or simulate leave no trace when they are only checked.
#[test]
fn check_touches_nothing_outside() {
    let folder = TempDir::new().unwrap();
    let text = format!(
        "{MODEL}file command write file_name = \"written.cmd\" entity_name = .m
file adams_data_set write file_name = \"written.adm\" model_name = .m
list_info part part_name = .m.a write_to_terminal = off file_name = \"written.txt\"
file text open file_name = \"text.txt\" open_mode = overwrite
file text write format_string = \"x\"
file text close
file temporary_settings save file_name = \"settings.cmd\"
file binary write file_name = \"written.bin\"
system command_text = \"touch system.txt\" echo_to_logfile = off
system command = \"touch system.txt\"
simulation single_run transient end_time = 0.1 number_of_steps = 3
simulation single_run equilibrium
model verify model_name = .m write_to_terminal = off file_name = \"verify.txt\"
file command write file_name = \"good.cmd\" entity_name = .m
variable set variable_name = .m.v integer_value = (eval(MKDIR(\"made\")))
variable set variable_name = .m.w integer_value = (eval(REMOVE_FILE(\"precious.txt\")))
"
    );
    put(&folder, "good.cmd", &text);
    put(&folder, "precious.txt", "precious");
    for format in ["text", "json", "sarif", "junit", "github"] {
        run(&folder, &["check", "--format", format, "good.cmd"], "");
    }
    let mut left: Vec<String> =
        fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    left.sort();
    assert_eq!(left, ["good.cmd", "precious.txt"]);
    assert_eq!(written(&folder, "good.cmd"), text);
}

#[test]
fn diff_of_models_tells_what_is_different_in_them() {
    let folder = TempDir::new().unwrap();
    put(&folder, "a.cmd", MODEL);
    // The same model in metres, with blanks elsewhere. What the beam is not given is 1 in the units in
    // force, and so not the same.
    let given = "   ixx = 1  iyy = 1  izz = 1  area_of_cross_section = 1  youngs_modulus = 1  shear_modulus = 1\n";
    put(&folder, "given.cmd", MODEL.replace("length = 100\n", "length = 100  &\n") + given);
    let given = "   ixx = 1E-12  iyy = 1E-12  izz = 1E-12  area_of_cross_section = 1E-6  youngs_modulus = 1E6  shear_modulus = 1E6\n";
    let metres = MODEL
        .replace("length = mm", "length = meter")
        .replace("-100, 0, 0", "-0.1,0,0")
        .replace("length = 100\n", "length = 0.1  &\n");
    put(&folder, "metres.cmd", metres + given);
    let (status, out, errors) = run(&folder, &["diff", "given.cmd", "metres.cmd"], "");
    assert_eq!(status, 0, "{out}{errors}");
    assert!(out.starts_with("note: the first model is in mm") && out.ends_with("no difference\n"), "{out}");
    let other = MODEL.replace("length = 100\n", "length = 90\n").replace(".m.a", ".m.arm")
        + "marker create marker_name = .m.ground.new location = 1, 2, 3\n";
    put(&folder, "b.cmd", &other);
    let (status, out, errors) = run(&folder, &["diff", "a.cmd", "b.cmd"], "");
    assert_eq!(status, 1, "{errors}");
    assert_eq!(
        out,
        "added    Marker .m.ground.new\nrenamed  Part .m.a -> .m.arm\nchanged  Beam .m.b\n            \
         length: 100.0 mm -> 90.0 mm\n3 differences\n"
    );
    let (status, out, _) = run(&folder, &["diff", "--format", "json", "b.cmd", "a.cmd"], "");
    assert_eq!(status, 1);
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["equal"], false);
    assert_eq!(report["differences"][0]["kind"], "removed");
    assert_eq!(report["differences"][1]["from"], ".m.arm");
    assert_eq!(report["differences"][2]["after"], "100.0 mm");
    assert_eq!(run(&folder, &["diff", "a.cmd", "-"], MODEL).0, 0);
    assert_eq!(run(&folder, &["diff", "a.cmd", "absent.cmd"], "").0, 1);
    assert_eq!(run(&folder, &["diff", "a.cmd", "absent.csv"], "").0, 2);
}

/// Our examples, laid out anew, make the same models.
#[test]
fn layout_of_the_examples_changes_no_model() {
    let folder = TempDir::new().unwrap();
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    fs::copy(examples.join("parametric/segment.mac"), folder.path().join("segment.mac")).unwrap();
    for name in ["axle", "cantilever", "four_bar", "parametric", "rotor"] {
        let text = fs::read_to_string(examples.join(name).join(format!("{name}.cmd"))).unwrap();
        // Every parameter on the line of its command, as people type.
        put(&folder, "dense.cmd", text.replace("  &\n   ", " "));
        put(&folder, "laid_out.cmd", text.replace("  &\n   ", " "));
        assert_eq!(run(&folder, &["fmt", "laid_out.cmd", "segment.mac"], "").0, 0);
        for file in ["dense", "laid_out"] {
            let (status, _, errors) =
                run(&folder, &["convert", &format!("{file}.cmd"), &format!("{file}_out.cmd")], "");
            assert_eq!(status, 0, "{errors}");
        }
        assert_eq!(written(&folder, "dense_out.cmd"), written(&folder, "laid_out_out.cmd"), "{name}");
        assert_eq!(run(&folder, &["diff", "dense.cmd", "laid_out.cmd"], "").0, 0);
    }
}

#[test]
fn check_with_fix_mends_datasets_too() {
    let folder = TempDir::new().unwrap();
    let good = "t\nUNITS/SYSTEM=MKS\nPART/1,GROUND\nMARKER/1, PART=1\nEND\n";
    let wrong = good.replace("MKS", "MKSS").replace("GROUND", "GROUNDD").replace("PART=", "PRT=");
    put(&folder, "m.adm", &wrong);
    let (status, out, errors) = run(&folder, &["check", "--fix", "--diff", "m.adm"], "");
    assert!(out.contains("-PART/1,GROUNDD\n") && out.contains("+PART/1,GROUND\n"), "{status} {out}\n{errors}");
    assert_eq!(written(&folder, "m.adm"), wrong, "looking changes nothing");
    let (status, _, errors) = run(&folder, &["check", "--fix", "m.adm"], "");
    assert_eq!((status, written(&folder, "m.adm").as_str()), (0, good), "{errors}");
}

#[test]
fn fmt_refuses_datasets_by_name() {
    let folder = TempDir::new().unwrap();
    put(&folder, "m.adm", "t\nPART/1,GROUND\nEND\n");
    let (status, out, errors) = run(&folder, &["fmt", "m.adm"], "");
    assert_eq!((status, out.as_str()), (1, ""));
    assert!(errors.contains("m.adm is a solver dataset"), "{errors}");
    assert_eq!(written(&folder, "m.adm"), "t\nPART/1,GROUND\nEND\n");
}
