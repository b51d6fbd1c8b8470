//! The traps of beams are found by name, and models are reported in Adams' words.

mod common;

use common::{Build, codes};
use flexure_elements::{Finding, Options, verify};
use model::ObjectId;
use schema::UnitSystem;

fn found(b: &Build) -> Vec<Finding> {
    verify(&b.database, b.model, Options::default()).findings
}

fn report(b: &Build) -> Vec<String> {
    verify(&b.database, b.model, Options::default()).report()
}

fn found_codes(b: &Build) -> Vec<&'static str> {
    codes(&found(b).into_iter().map(|f| f.diagnostic).collect::<Vec<_>>())
}

/// A beam from ground to a part whose marker lies at `x` in the J marker.
fn beam_with_i_at(x: f64, length: f64) -> (Build, ObjectId) {
    let mut b = Build::new(UnitSystem::mmks());
    let root = b.marker(b.ground, "root", [0.0; 3]);
    let part = b.part("p", [x, 0.0, 0.0], 2.0, 100.0);
    let i = b.marker(part, "i", [0.0; 3]);
    let beam = b.beam("bar", i, root, length);
    (b, beam)
}

#[test]
fn a_good_beam_has_no_findings() {
    let (b, _) = beam_with_i_at(5000.0, 5000.0);
    assert_eq!(found(&b), []);
}

#[test]
fn swapped_ends_are_named_with_the_distance_and_the_fix() {
    let (b, _) = beam_with_i_at(-5000.0, 5000.0);
    let found = found(&b);
    assert_eq!(found.len(), 1, "{found:?}");
    let one = &found[0];
    assert_eq!(one.diagnostic.code, "beam/ends-swapped");
    assert!(one.diagnostic.is_error());
    assert_eq!(one.diagnostic.message, "I and J of beam `.m.bar` are swapped: I lies on -x of J, at x = -5000 mm");
    assert_eq!(
        one.fix.as_deref(),
        Some("force modify element_like beam beam_name=.m.bar i_marker_name=.m.ground.root j_marker_name=.m.p.i")
    );
}

#[test]
fn coincident_markers_are_named() {
    let (b, _) = beam_with_i_at(0.0, 10.0);
    assert_eq!(found_codes(&b), ["beam/coincident-markers"]);
}

/// Truth: 420.3 mm against 420 mm is a strain of 0.3/420, times EA = 2.07e5 * 78.5 N: 11606.9 N.
#[test]
fn a_wrong_length_is_named_with_the_force_it_makes() {
    let (b, _) = beam_with_i_at(420.3, 420.0);
    let found = found(&b);
    let all: Vec<_> = found.iter().map(|f| f.diagnostic.code).collect();
    assert_eq!(all, ["beam/length", "beam/preloaded"]);
    assert!(found[0].fix.as_deref().is_some_and(|fix| fix.ends_with("length=420.3")), "{:?}", found[0].fix);
    assert!(found[1].diagnostic.notes[0].contains("force -11606.8, 0, 0 newton"), "{:?}", found[1].diagnostic.notes);
}

#[test]
fn a_marker_off_the_axis_is_named() {
    let (mut b, _) = beam_with_i_at(100.0, 100.0);
    let part = b.database.find(".m.p", "part").unwrap();
    b.numbers(part, "location", &[100.0, 10.0, 0.0]);
    let all = found_codes(&b);
    assert!(all.contains(&"beam/off-axis") && all.contains(&"beam/preloaded"), "{all:?}");
}

#[test]
fn impossible_and_doubtful_section_data_is_named() {
    let (mut b, beam) = beam_with_i_at(500.0, 500.0);
    b.set(beam, "y_shear_area_ratio", 0.9);
    b.set(beam, "z_shear_area_ratio", 0.8);
    assert_eq!(found_codes(&b), ["beam/shear-ratio", "beam/shear-ratio"]);
    b.set(beam, "y_shear_area_ratio", 1.2);
    b.set(beam, "z_shear_area_ratio", 0.0);
    assert!(found(&b).is_empty());
    b.set(beam, "ixx", 1.0);
    assert_eq!(found_codes(&b), ["beam/default-of-one"]);
    b.set(beam, "izz", 509.0);
    b.set(beam, "ixx", 1000.0);
    assert_eq!(found_codes(&b), ["beam/polar-moment"]);
    b.set(beam, "ixx", 900.0);
    b.numbers(beam, "matrix_of_damping_terms", &[0.0; 21]);
    assert_eq!(found_codes(&b), ["beam/damping-twice"]);
}

#[test]
fn a_beam_within_one_part_is_named() {
    let mut b = Build::new(UnitSystem::mmks());
    let part = b.part("p", [0.0; 3], 2.0, 100.0);
    let (i, j) = (b.marker(part, "i", [500.0, 0.0, 0.0]), b.marker(part, "j", [0.0; 3]));
    b.beam("bar", i, j, 500.0);
    assert_eq!(found_codes(&b), ["beam/one-part"]);
}

/// Truth: a planar four-bar of three parts and four revolute joints has 18 - 20 = -2 by counting, 1
/// degree of freedom, and three redundant equations.
#[test]
fn a_four_bar_is_reported_in_the_words_of_adams() {
    let mut b = Build::new(UnitSystem::mmks());
    let corners = [[0.0, 0.0, 0.0], [0.0, 100.0, 0.0], [200.0, 150.0, 0.0], [200.0, 0.0, 0.0]];
    let parts: Vec<_> = (0..3).map(|n| b.part(&format!("link_{n}"), [0.0; 3], 1.0, 100.0)).collect();
    let around = [b.ground, parts[0], parts[1], parts[2], b.ground];
    for (n, corner) in corners.into_iter().enumerate() {
        let i = b.marker(around[n + 1], &format!("i{n}"), corner);
        let j = b.marker(around[n], &format!("j{n}"), corner);
        b.joint("joint_revolute", &format!("JOINT_{n}"), i, j);
    }
    let report = report(&b);
    let lines: Vec<&str> = report.iter().map(String::as_str).collect();
    assert_eq!(
        lines[..8],
        [
            "VERIFY MODEL: .m",
            "",
            "-2 Gruebler Count (approximate degrees of freedom)",
            "3 Moving Parts (not including ground)",
            "4 Revolute Joints",
            "",
            "1 Degrees of Freedom for .m",
            "",
        ]
    );
    assert_eq!(lines[8], "There are 3 redundant constraint equations.");
    assert!(lines[11].starts_with(".m.JOINT_3 (Revolute Joint)"), "{lines:?}");
    assert_eq!(*lines.last().unwrap(), "Model verified successfully");
}

/// Adams' words are kept for models without errors.
#[test]
fn a_model_with_an_error_is_not_called_verified() {
    for x in [-5000.0, 5000.0] {
        let (mut b, beam) = beam_with_i_at(x, 5000.0);
        let verdict = |b: &Build| report(b).pop().unwrap();
        let expected = if x < 0.0 { "Model not verified: 1 error" } else { "Model verified successfully" };
        assert_eq!(verdict(&b), expected);
        // This one cannot be lowered at all.
        b.set(beam, "youngs_modulus", -1.0);
        let lines = report(&b);
        assert!(lines.iter().any(|line| line.starts_with("ERROR:  `youngs_modulus`")), "{lines:?}");
        assert!(verdict(&b).starts_with("Model not verified: "), "{lines:?}");
    }
}

#[test]
fn a_part_without_mass_that_can_move_is_named() {
    let mut b = Build::new(UnitSystem::mmks());
    b.add("part", b.model, "p");
    assert_eq!(found_codes(&b), ["part/no-mass", "part/no-mass-but-free"]);
}

/// Truth: 25 degrees are three beams with at most 10 degrees each.
#[test]
fn a_bent_beam_says_how_many_would_do() {
    let (mut b, _) = beam_with_i_at(5000.0, 5000.0);
    let marker = b.database.find(".m.p.i", "marker").unwrap();
    b.numbers(marker, "orientation", &[25.0, 0.0, 0.0]);
    let found = found(&b);
    let axes = found.iter().find(|f| f.diagnostic.code == "beam/axes").unwrap();
    assert!(axes.diagnostic.helps[0].text.contains("3 beams"), "{axes:?}");
}
