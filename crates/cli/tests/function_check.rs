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

/// What a name may stand for where a number is wanted, below the model that the other tests have.
const NUMBERS: &str = "variable create variable_name=.m.real real_value=2
variable create variable_name=.m.whole integer_value=3
variable create variable_name=.m.word string_value=\"x\"
variable create variable_name=.m.held object_value=.m.ground.root
data_element create variable variable_name=.m.state function=\"TIME\"
measure create function measure_name=.m.measured function=\"TIME\"
output_control create request request_name=.m.recorded f2=\"TIME\"
";

fn checked_with_numbers(function: &str) -> (i32, String) {
    let folder = TempDir::new().unwrap();
    let request = format!("output_control create request request_name=.m.r f3=\"{function}\"\n");
    fs::write(folder.path().join("m.cmd"), format!("{MODEL}{NUMBERS}{request}")).unwrap();
    run(&folder, &["check", "m.cmd"])
}

/// Numbers: a design variable that holds one, a measure, and the cells of objects that hold one.
#[test]
fn names_that_have_a_number_pass() {
    for function in [
        "2*.m.real",
        "real+whole",
        ".m.whole*TIME",
        "2*.m.measured",
        ".m.b1.length",
        ".m.p.mass",
        "STEP(TIME,0,0,1,.m.real.real_value)",
    ] {
        let (status, errors) = checked_with_numbers(function);
        assert_eq!((status, errors.as_str()), (0, "0 errors, 0 warnings\n"), "{function}");
    }
}

/// Everything else has none, and the sentence says what the name means instead.
#[test]
fn names_that_have_no_number_are_errors() {
    let none = "is not a number, a constant or a function";
    for (function, sentence) in [
        ("2*.no.such.thing.at.all", format!("`.no.such.thing.at.all` {none}")),
        ("2*.m.b1.lenght", format!("`.m.b1.lenght` {none}; a beam has no `lenght`")),
        ("2*.m.b1.formulation", format!("`.m.b1.formulation` {none}; `formulation` of a beam is no number")),
        ("2*.m.b1.adams_id", format!("`.m.b1.adams_id` {none}; `adams_id` of that beam is not given")),
        ("2*.m.p.cm.location", format!("`.m.p.cm.location` {none}; `location` of a marker is no number")),
        ("2*.m.b1", format!("`.m.b1` {none}; `.m.b1` is a beam")),
        ("2*.m.p.cm", format!("`.m.p.cm` {none}; `.m.p.cm` is a marker")),
        ("2*.m.p", format!("`.m.p` {none}; `.m.p` is a part")),
        ("2*.m.recorded", format!("`.m.recorded` {none}; `.m.recorded` is a request")),
        ("2*.m.word", format!("`.m.word` {none}; it is a variable that holds no number")),
        ("2*.m.held", format!("`.m.held` {none}; it is a variable that holds no number")),
        ("2*.m.state", format!("`.m.state` {none}; VARVAL(.m.state) is its value")),
    ] {
        let (status, errors) = checked_with_numbers(function);
        assert_eq!(status, 1, "{function}: {errors}");
        assert!(errors.contains("error[function/unknown-name]") && errors.contains(&sentence), "{function}: {errors}");
    }
}

/// A computed measure is over results too, which no model holds before it is run.
#[test]
fn computed_measures_may_name_results() {
    let folder = TempDir::new().unwrap();
    for (name, expected) in [(".m.Last_Run.TIP.X", 0), (".m.nothing", 1)] {
        let measure = format!("measure create computed measure_name=.m.c text_of_expression=\"2*{name}\"\n");
        fs::write(folder.path().join("m.cmd"), format!("{MODEL}{measure}")).unwrap();
        let (status, errors) = run(&folder, &["check", "m.cmd"]);
        assert_eq!(status, expected, "{name}: {errors}");
    }
}

/// Twin: the same function with the number that the name stands for.
#[test]
fn a_cell_has_its_number_in_a_run() {
    let folder = TempDir::new().unwrap();
    let recorded = |function: &str| {
        let request = format!("output_control create request request_name=.m.r f3=\"{function}\"\n");
        fs::write(folder.path().join("m.cmd"), format!("{MODEL}{NUMBERS}{request}")).unwrap();
        let (status, errors) = run(&folder, &["simulate", "m.cmd", "--static", "--out", "o.csv"]);
        assert_eq!(status, 0, "{errors}");
        fs::read_to_string(folder.path().join("o.csv")).unwrap()
    };
    assert_eq!(recorded("2*.m.b1.length+.m.whole"), recorded("2*500+3"));
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
