//! `flexure check` on run-time functions, and on files that Flexure wrote, from outside.

use std::fs;

use assert_cmd::Command;
use tempfile::TempDir;

fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let output = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).output().unwrap();
    (output.status.code().unwrap_or(-1), String::from_utf8_lossy(&output.stderr).into_owned())
}

const MODEL: &str = "model create model_name=m
part create rigid_body name_and_position part_name=.m.p
marker create marker_name=.m.p.cm
part create rigid_body mass_properties part_name=.m.p mass=1 center=.m.p.cm ixx=1 iyy=1 izz=1
marker create marker_name=.m.ground.root
force create element_like beam beam_name=.m.b1 i_marker_name=.m.p.cm j_marker_name=.m.ground.root &
  length=500 area=100 ixx=1600 iyy=800 izz=800 youngs=2E5 shear=8E4
";

fn checked(function: &str) -> (i32, String) {
    let folder = TempDir::new().unwrap();
    let request = format!("output_control create request request_name=.m.r &\n  f2=\"{function}\"\n");
    fs::write(folder.path().join("m.cmd"), format!("{MODEL}{request}")).unwrap();
    run(&folder, &["check", "m.cmd"])
}

/// Line 9 holds the function; each mistake is one error there.
#[test]
fn functions_that_cannot_be_used_are_errors_at_their_place() {
    for (function, code) in [
        ("10*BEAM(b1,0,3,0)+STEP(TIME,0,0,1", "error[function/"),
        ("BEAM(b7,0,3,0)", "error[function/unknown-object]"),
        ("BEAM(.m.p.cm,0,3,0)", "error[function/unknown-object]"),
        ("BEAM(b1,2,9,0)", "error[function/wrong-argument]"),
        ("BEAM(b1,0)", "error[function/wrong-argument-count]"),
        ("STP(TIME,0,0,1,1)", "error[function/unknown-function]"),
    ] {
        let (status, errors) = checked(function);
        assert_eq!(status, 1, "{function}: {errors}");
        assert!(errors.contains(code) && errors.contains("--> m.cmd:9:"), "{function}: {errors}");
        assert!(!errors.contains("warning["), "{function}: {errors}");
    }
}

#[test]
fn functions_that_can_be_used_pass() {
    for function in [
        "10*BEAM(b1,0,3,0)+STEP(TIME,0,0,1,1)",
        "DX(cm,root)*.m.k",
        "BEAM(1,0,3)*PI",
        "VARVAL(1)",
        "BEAM(b1,0,2,.m.axes)",
    ] {
        let folder = TempDir::new().unwrap();
        let more = "variable create variable_name=.m.k real_value=2\n\
                    variable create variable_name=.m.axes object_value=.m.ground.root\n\
                    force modify element_like beam beam_name=.m.b1 adams_id=1\n";
        let request = format!("output_control create request request_name=.m.r f2=\"{function}\"\n");
        fs::write(folder.path().join("m.cmd"), format!("{MODEL}{more}{request}")).unwrap();
        let (status, errors) = run(&folder, &["check", "m.cmd"]);
        assert_eq!((status, errors.as_str()), (0, "0 errors, 0 warnings\n"), "{function}");
    }
}

/// What Flexure writes it reads without a word, also where every word stops it.
#[test]
fn a_file_that_was_written_is_read_in_silence() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("m.cmd"), MODEL).unwrap();
    assert_eq!(run(&folder, &["convert", "m.cmd", "n.cmd"]).0, 0);
    let (status, errors) = run(&folder, &["run", "--strict", "n.cmd"]);
    assert!(status == 0 && errors.contains("0 errors, 0 warnings"), "{errors}");
}
