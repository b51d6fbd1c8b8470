//! Every example runs and gives what its `truth.toml` says.

use std::fs;
use std::path::{Path, PathBuf};

use flexure::{Run, Session};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Truth {
    check: Vec<Check>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Check {
    run: usize,
    series: String,
    at: At,
    value: f64,
    kind: String,
    tolerance: Tolerance,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum At {
    Time(f64),
    Word(String),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Tolerance {
    #[serde(default)]
    rel: f64,
    #[serde(default)]
    abs: f64,
    because: String,
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

fn run(name: &str) -> Vec<Run> {
    let mut session = Session::new();
    let report = session.read(&folder(name).join(format!("{name}.cmd")));
    assert!(report.diagnostics.is_empty(), "{}", session.render(&report.diagnostics, false));
    session.take_runs()
}

fn value(run: &Run, check: &Check) -> f64 {
    let series = run.table.get(&check.series).unwrap_or_else(|| panic!("no series {}", check.series));
    let times = &run.table.series[0].values;
    let row = match &check.at {
        At::Time(t) => times.iter().position(|x| (x - t).abs() < 1e-9).expect("an output at that time"),
        At::Word(word) => {
            assert_eq!(word, "end", "`at` is a time or \"end\"");
            times.len() - 1
        }
    };
    series.values[row]
}

fn verify(name: &str) {
    let truth: Truth = toml::from_str(&fs::read_to_string(folder(name).join("truth.toml")).unwrap()).unwrap();
    let runs = run(name);
    assert!(!truth.check.is_empty());
    for check in &truth.check {
        assert!(["truth", "twin"].contains(&check.kind.as_str()) && !check.tolerance.because.is_empty());
        let found = value(&runs[check.run - 1], check);
        let allowed = check.tolerance.abs + check.tolerance.rel * check.value.abs();
        let off = (found - check.value).abs();
        assert!(off <= allowed, "{name} run {} {}: {found} is {off:e} off {}", check.run, check.series, check.value);
    }
}

#[test]
fn cantilever_bends_like_beam_theory_says() {
    verify("cantilever");
}

#[test]
fn rotor_carries_its_centrifugal_force() {
    verify("rotor");
}

#[test]
fn axle_twists_its_bar() {
    verify("axle");
}

#[test]
fn four_bar_moves_like_a_parallelogram() {
    verify("four_bar");
}

#[test]
fn parametric_strip_follows_its_variables() {
    verify("parametric");
}

#[test]
fn every_example_is_tested_here() {
    let mut names: Vec<String> = fs::read_dir(folder("."))
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|n| folder(n).is_dir())
        .collect();
    names.sort();
    assert_eq!(names, ["axle", "cantilever", "four_bar", "parametric", "rotor"]);
}
