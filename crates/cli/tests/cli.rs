//! The command line from outside: what is printed, what is written, how it exits.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

/// A part with a marker and one on ground; commands are appended.
const SCENE: &str = "\
defaults units length=mm angle=deg force=newton mass=kg time=sec
model create model_name = m
part create rigid_body name_and_position part_name = .m.a location = 0,0,0
marker create marker_name = .m.a.cm location = 0,0,0 relative_to = .m.a
part create rigid_body mass_properties part_name=.m.a mass=1 center_of_mass_marker=.m.a.cm ixx=1 iyy=1 izz=1
marker create marker_name = .m.ground.r location = -100,0,0 relative_to = .m.ground
";
const LINES: usize = 6;
const BEAM: &str = "force create element_like beam beam_name=.m.b i_marker_name=.m.a.cm j_marker_name=.m.ground.r";

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name).join(format!("{name}.cmd"))
}

/// Runs the program in a folder; returns exit status, standard output and standard error.
fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let output = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

fn written(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

/// The mistake in the line after the scene gives a diagnostic with this code at this column, the
/// model stays as it was, and the exit status is 1.
fn refused(command: &str, code: &str, column: usize) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("good.cmd"), SCENE).unwrap();
    fs::write(folder.path().join("bad.cmd"), format!("{SCENE}{command}\n")).unwrap();
    let (status, _, errors) = run(&folder, &["run", "bad.cmd"]);
    assert_eq!(status, 1, "{errors}");
    let place = format!("bad.cmd:{}:{column}", LINES + 1);
    assert!(errors.contains(&format!("error[{code}]")) && errors.contains(&place), "{code} at {place}:\n{errors}");
    assert!(!errors.contains("internal error"), "{errors}");
    run(&folder, &["convert", "good.cmd", "good_out.cmd"]);
    run(&folder, &["convert", "bad.cmd", "bad_out.cmd"]);
    assert_eq!(written(&folder, "good_out.cmd"), written(&folder, "bad_out.cmd"));
}

#[test]
fn an_unknown_parameter_is_refused() {
    refused(&format!("{BEAM} lenght = 100"), "command/unknown-argument", 95);
}

#[test]
fn a_missing_marker_is_refused() {
    refused(
        "force create element_like beam i_marker_name = .m.a.tip j_marker_name = .m.ground.r",
        "name/not-found",
        48,
    );
}

#[test]
fn a_wrong_unit_is_refused() {
    refused(&format!("{BEAM} length = (100newton)"), "unit/wrong-dimension", 104);
}

#[test]
fn a_duplicate_name_is_refused() {
    refused("part create rigid_body name_and_position part_name = .m.a", "name/taken", 54);
}

#[test]
fn twenty_damping_terms_are_refused() {
    let terms = ["0.1"; 20].join(",");
    refused(&format!("{BEAM} matrix_of_damping_terms = {terms}"), "command/wrong-count", 121);
}

#[test]
fn an_infinite_number_is_refused() {
    refused(&format!("{BEAM} length = 1e999"), "syntax/number-out-of-range", 104);
}

#[test]
fn a_marker_without_a_part_is_refused() {
    refused("marker create marker_name = .m.lost location = 0,0,0", "name/no-parent", 29);
}

#[test]
fn an_unclosed_quote_is_refused() {
    refused("part create rigid_body name_and_position comments = \"begun", "syntax/unclosed-quote", 53);
}

#[test]
fn a_beam_without_length_is_refused_when_it_is_simulated() {
    let folder = TempDir::new().unwrap();
    let commands = format!("{SCENE}{BEAM} length = 0\nsimulation single_run equilibrium\n");
    fs::write(folder.path().join("bad.cmd"), commands).unwrap();
    let (status, _, errors) = run(&folder, &["run", "bad.cmd"]);
    assert_eq!(status, 1);
    assert!(errors.contains("error[beam/not-positive]: `length` of beam `.m.b` is 0"), "{errors}");
    assert!(errors.contains("bad.cmd:8:1"), "{errors}");
}

#[test]
fn random_bytes_are_refused_without_a_panic() {
    let folder = TempDir::new().unwrap();
    // A linear congruential generator: bytes without meaning, the same each time.
    let mut state = 12345_u32;
    let mut byte = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    fs::write(folder.path().join("noise.cmd"), (0..20_000).map(|_| byte()).collect::<Vec<_>>()).unwrap();
    let (status, _, errors) = run(&folder, &["run", "noise.cmd"]);
    assert_eq!(status, 1);
    assert!(errors.contains("noise.cmd:1:") && !errors.contains("internal error"), "{errors}");
}

#[test]
fn a_file_that_is_not_there_and_wrong_usage_have_their_own_status() {
    let folder = TempDir::new().unwrap();
    let (status, _, errors) = run(&folder, &["run", "nowhere.cmd"]);
    assert_eq!(status, 1);
    assert!(errors.contains("nowhere.cmd"), "{errors}");
    assert_eq!(run(&folder, &["frobnicate"]).0, 2);
    assert_eq!(run(&folder, &["simulate", "m.cmd", "--out", "x.csv"]).0, 2);
    assert_eq!(run(&folder, &["--help"]).0, 0);
}

#[test]
fn a_run_writes_its_results_and_its_journal() {
    let folder = TempDir::new().unwrap();
    let file = example("cantilever");
    let arguments = ["run", file.to_str().unwrap(), "--out", "out", "--journal", "aview.log"];
    let (status, output, errors) = run(&folder, &arguments);
    assert_eq!(status, 0, "{errors}");
    assert_eq!(output.lines().count(), 4, "{output}");
    let table = written(&folder, "out/cantilever_1_static.csv");
    assert!(table.starts_with("time,TIP.X,TIP.Y,TIP.Z,TIP.MAG,"), "{table}");
    let journal = written(&folder, "aview.log");
    assert!(journal.contains("! >> force modify element_like beam"), "{journal}");
}

#[test]
fn a_model_is_simulated_after_an_edit() {
    let folder = TempDir::new().unwrap();
    let file = example("cantilever");
    let edit = "force modify element_like beam beam_name = beam_1 youngs_modulus = 1.0E+05";
    let mut arguments = vec!["simulate", file.to_str().unwrap(), "-e", edit];
    arguments.extend(["--static", "--end", "0.01", "--steps", "10", "--out", "r.parquet"]);
    let (status, output, errors) = run(&folder, &arguments);
    assert_eq!((status, output.as_str()), (0, "r.parquet\n"), "{errors}");
    let (status, output, _) = run(&folder, &["plot", "r.parquet", "-o", "r.svg", "-s", "TIP.Z"]);
    assert_eq!((status, output.as_str()), (0, "r.svg\n"));
    assert!(written(&folder, "r.svg").contains("TIP.Z (mm)"));
}

#[test]
fn swapped_markers_are_found_named_and_mended() {
    let folder = TempDir::new().unwrap();
    let file = example("cantilever");
    let swap = "force modify element_like beam beam_name = beam_3 i_marker_name = .cantilever.node_2.cm \
                j_marker_name = .cantilever.node_3.cm";
    let arguments = ["verify", file.to_str().unwrap(), "-e", swap, "--fix", "--out", "mended.cmd"];
    let (status, _, errors) = run(&folder, &arguments);
    assert_eq!(status, 1);
    assert!(errors.contains("error[beam/ends-swapped]") && errors.contains(".cantilever.beam_3"), "{errors}");
    assert!(errors.contains("x = -250 mm"), "{errors}");
    let (status, _, errors) = run(&folder, &["verify", "mended.cmd"]);
    assert_eq!(status, 0, "{errors}");
}

#[test]
fn modes_are_printed_and_written() {
    let folder = TempDir::new().unwrap();
    let file = example("cantilever");
    let (status, output, errors) = run(&folder, &["modes", file.to_str().unwrap(), "--json"]);
    assert_eq!(status, 0, "{errors}");
    let found: serde_json::Value = serde_json::from_str(&output).unwrap();
    // Four parts with six motions each: 48 eigenvalues, an oscillating mode stands for two.
    let modes = found["modes"].as_array().unwrap();
    let eigenvalues: usize = modes.iter().map(|m| if m["imaginary"].as_f64() == Some(0.0) { 1 } else { 2 }).sum();
    assert_eq!(eigenvalues, 48);
    assert_eq!(run(&folder, &["modes", file.to_str().unwrap(), "--out", "modes.csv"]).0, 0);
    assert!(written(&folder, "modes.csv").starts_with("mode,frequency_hz,"));
}

#[test]
fn what_is_supported_is_listed() {
    let folder = TempDir::new().unwrap();
    let (status, output, _) = run(&folder, &["support"]);
    assert_eq!(status, 0);
    for line in ["force create element_like beam", "file command read", "simulation single_run transient"] {
        assert!(output.contains(line), "{line} is missing in\n{output}");
    }
}

/// Truth: b h³/12, 6/5, and Saint-Venant's series of a square, 0.1405770149.
#[test]
fn a_section_is_computed_and_drawn() {
    let folder = TempDir::new().unwrap();
    let sizes = ["section", "rectangle", "--width", "20", "--height", "20", "--out", "s.svg"];
    let (status, out, err) = run(&folder, &sizes);
    assert_eq!((status, err.as_str()), (0, ""));
    for part in ["22492.32", "13333.33", "mm**4", "1.2", "Saint-Venant", "s.svg"] {
        assert!(out.contains(part), "{part} is missing in {out}");
    }
    assert!(written(&folder, "s.svg").contains("polygon"));
    let (status, out, _) =
        run(&folder, &["section", "circle", "--diameter", "2", "--theory", "cowper", "--nu", "0", "--format", "json"]);
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(status, 0);
    assert!((report["z_shear_area_ratio"].as_f64().unwrap() - 7.0 / 6.0).abs() < 1e-15);
    assert_eq!(report["area_of_cross_section"], std::f64::consts::PI);
}

#[test]
fn a_section_that_is_none_is_refused() {
    let folder = TempDir::new().unwrap();
    for (arguments, part) in [
        (&["section", "rectangle", "--width", "20"][..], "needs --height"),
        (&["section", "circle", "--diameter", "2", "--height", "1"], "has no --height"),
        (&["section", "tube", "--diameter", "2", "--thickness", "1"], "does not leave room"),
        (&["section", "circle", "--diameter", "-2"], "must be above 0"),
        (&["section", "circle", "--diameter", "2", "--nu", "0.7"], "at most 0.5"),
        (&["section", "circle", "--diameter", "2", "--out", "s.pdf"], ".svg or .png"),
        (&["section", "hexagon"], "rectangle"),
    ] {
        let (status, _, err) = run(&folder, arguments);
        assert_eq!(status, 2, "{arguments:?}");
        assert!(err.contains(part), "{part} is missing in {err}");
    }
}

/// The table of a command as JSON.
fn table(words: &[&str]) -> serde_json::Value {
    let arguments = [&["support"], words, &["--format", "json"]].concat();
    serde_json::from_str(&run(&TempDir::new().unwrap(), &arguments).1).unwrap()
}

/// Truth: the schema of the beam; the sentences are those of `help`.
#[test]
fn a_command_is_explained_as_text_and_as_json() {
    let words = ["force", "modify", "element_like", "beam"];
    let (_, text, _) = run(&TempDir::new().unwrap(), &[&["support"], &words[..]].concat());
    let table = table(&words);
    assert_eq!(table["command"], "force modify element_like beam");
    let parameters = table["parameters"].as_array().unwrap();
    assert!(parameters.len() > 15 && text.lines().count() == 1 + parameters.len(), "{text}");
    for (parameter, line) in parameters.iter().zip(text.lines().skip(1)) {
        let of = |key: &str| parameter[key].as_str().unwrap();
        let line = line.trim_start();
        assert!(line.starts_with(of("name")) && line.ends_with(of("doc")) && line.contains(of("type")), "{line}");
    }
    let length = parameters.iter().find(|p| p["name"] == "length").unwrap();
    assert_eq!(length["dimension"], "length");
    assert_eq!(length["shortest"], "l");
    assert_eq!(length["keyword"], "LENGTH");
    assert!(length["default"].is_null() && length["must_be"] == "greater than 0");
}

#[test]
fn exclusive_parameters_stand_in_the_table() {
    let table = table(&["forc cr el beam"]);
    let rules = table["rules"].as_array().unwrap();
    let ends = serde_json::json!({ "rule": "at_most_one", "names": ["i_marker_name", "i_part_name"] });
    assert!(rules.contains(&ends), "{rules:?}");
    let formulation = table["parameters"].as_array().unwrap().iter().find(|p| p["name"] == "formulation").unwrap();
    assert_eq!(formulation["words"], serde_json::json!(["linear", "string", "nonlinear"]));
    assert_eq!(formulation["default"], "linear");
}

#[test]
fn an_unknown_command_is_not_explained() {
    let words = ["support", "force", "modify", "element_like", "beem"];
    let (status, _, trouble) = run(&TempDir::new().unwrap(), &words);
    assert_eq!(status, 2);
    assert!(trouble.contains("did you mean `beam`?"), "{trouble}");
}

/// Truth: the elastica turns by 12 degrees over the first quarter of this cantilever, so that one linear
/// beam there is past 10 degrees, and two of them are not.
#[test]
fn a_run_names_the_beams_that_are_bent_beyond_their_range() {
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mechanisms/beams/beams.cmd");
    let folder = TempDir::new().unwrap();
    let edits = ["chain n=4", "tip force y=1", "simulation single_run equilibrium model_name=.chain"];
    let mut arguments = vec!["run", model.to_str().unwrap(), "--out", "out"];
    edits.iter().for_each(|edit| arguments.extend(["-e", edit]));
    let (status, _, trouble) = run(&folder, &arguments);
    assert_eq!(status, 0, "{trouble}");
    assert!(trouble.contains("run/beyond-validity") && trouble.contains(".chain.beam_1: 11.8 degrees"), "{trouble}");
    assert!(trouble.contains("2 in its place would do"), "{trouble}");
}
