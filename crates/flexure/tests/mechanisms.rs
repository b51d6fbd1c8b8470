//! Whole models with known answers: every `mechanisms/*/truth.toml` is run through commands and
//! compared. Every beam of every run must be in balance.

use std::fs;
use std::path::{Path, PathBuf};

#[path = "mechanisms/balance.rs"]
mod balance;
#[path = "mechanisms/run.rs"]
mod run;
#[path = "mechanisms/truth.rs"]
mod truth;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mechanisms").join(name)
}

fn verify(name: &str) {
    let folder = folder(name);
    let text = fs::read_to_string(folder.join("truth.toml")).unwrap();
    let truth: truth::Truth = toml::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
    let troubles: Vec<String> =
        truth.case.iter().flat_map(|case| run::troubles(&folder, &truth.models, case)).collect();
    assert!(!truth.case.is_empty());
    assert!(troubles.is_empty(), "{} wrong in {name}:\n{}", troubles.len(), troubles.join("\n"));
}

#[test]
fn small_loads_bend_a_beam_like_linear_theory() {
    verify("small_loads");
}

#[test]
fn a_transverse_tip_load_makes_an_elastica() {
    verify("elastica");
}

#[test]
fn an_end_moment_rolls_a_beam_up() {
    verify("roll_up");
}

#[test]
fn an_axial_load_buckles_a_cantilever() {
    verify("buckling");
}

#[test]
fn chains_have_the_frequencies_of_their_matrices() {
    verify("frequencies");
}

#[test]
fn a_spinning_beam_is_stiffer() {
    verify("rotating");
}

#[test]
fn a_beam_lags_behind_the_hub_that_spins_it_up() {
    verify("spin_up");
}

#[test]
fn a_slanted_load_bends_and_twists_the_princeton_beam() {
    verify("princeton");
}

#[test]
fn every_mechanism_is_tested_here() {
    let mut names: Vec<String> = fs::read_dir(folder("."))
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|n| folder(n).join("truth.toml").is_file())
        .collect();
    names.sort();
    let tested = ["buckling", "elastica", "frequencies", "princeton", "roll_up", "rotating", "small_loads", "spin_up"];
    assert_eq!(names, tested);
    assert!(names.iter().all(|n| folder(n).join("README.md").is_file()));
}
