//! Comparison with public exports; skipped where the folder of shared data is not there.

mod support;

use std::path::PathBuf;

use flexure_dataset::read_statements;
use model::Value;
use schema::UnitSystem;
use support::{Bench, text};
use text::FileId;

fn shared(path: &str) -> Option<String> {
    let Some(folder) = std::env::var_os("FLEXURE_SHARED").map(PathBuf::from) else {
        println!("skipped: FLEXURE_SHARED is not set");
        return None;
    };
    let path = folder.join("corpus").join(path);
    let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    Some(String::from_utf8_lossy(&bytes).replace('\r', ""))
}

/// Truth: a public export of Adams View of a model with two joints, a primitive joint and a motion,
/// rebuilt by hand from the command file beside it.
#[test]
fn the_generic_model_is_written_byte_for_byte() {
    let Some(expected) = shared("bthornton191__adamspy/generic_model/generic_model.adm") else { return };
    let units = UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees").unwrap();
    let mut b = Bench::new("generic_model", units);
    let (ground, model) = (b.ground, b.model);
    let m5 = b.marker(ground, "MARKER_5", 5, [0.0; 3], [0.0; 3]);
    let m10 = b.marker(ground, "MARKER_10", 10, [12.0, 0.0, 0.0], [270.0, 90.0, 180.0]);

    let part2 = b.add("part", model, "PART_2", 2);
    b.marker(part2, "MARKER_1", 1, [0.0; 3], [90.0, 0.0, 0.0]);
    b.marker(part2, "MARKER_2", 2, [0.0, 6.0, 0.0], [90.0, 0.0, 0.0]);
    let cm = b.marker(part2, "cm", 11, [0.0, 3.0, 0.0], [180.0, 90.0, 90.0]);
    let m6 = b.marker(part2, "MARKER_6", 6, [0.0; 3], [0.0; 3]);
    let m7 = b.marker(part2, "MARKER_7", 7, [0.0, 6.0, 0.0], [0.0; 3]);
    b.mass(part2, 0.2249795587, cm, [0.7699990204, 0.7665580576, 0.0057844999]);

    let part3 = b.add("part", model, "PART_3", 3);
    let tilt = 333.4349488229;
    b.marker(part3, "MARKER_3", 3, [0.0, 6.0, 0.0], [tilt, 0.0, 0.0]);
    b.marker(part3, "MARKER_4", 4, [12.0, 0.0, 0.0], [tilt, 0.0, 0.0]);
    let cm = b.marker(part3, "cm", 12, [6.0, 3.0, 0.0], [tilt - 90.0, 90.0000000239, 90.0000004979]);
    let m8 = b.marker(part3, "MARKER_8", 8, [0.0, 6.0, 0.0], [0.0; 3]);
    let m9 = b.marker(part3, "MARKER_9", 9, [12.0, 0.0, 0.0], [270.0, 90.0, 180.0]);
    b.mass(part3, 0.4862494147, cm, [7.731451846, 7.723928542, 0.0125884023]);

    let joint = b.model_object("joint_revolute", "JOINT_1", 1);
    b.between(joint, m5, m6);
    let other = b.model_object("joint_revolute", "JOINT_2", 2);
    b.between(other, m7, m8);
    let inline = b.model_object("jprim_inline", "JOINT_3", 1);
    b.between(inline, m9, m10);
    let motion = b.model_object("motion", "MOTION_1", 1);
    b.word(motion, "type_of_freedom", "rotational");
    b.set(motion, "joint_name", Value::Object(joint));
    b.function(motion, "function", vec![text("30.0d * time")]);
    let written = b.text();
    for (line, (ours, theirs)) in written.lines().zip(expected.lines()).enumerate() {
        assert_eq!(ours, theirs, "line {}", line + 1);
    }
    assert_eq!(written.trim_end(), expected.trim_end());
}

/// Truth: lines that begin with the name of the statement, counted by hand with grep.
#[test]
fn statements_of_exports_are_counted() {
    for (path, counts) in [
        (
            "bthornton191__adamspy/test_analysis_1.adm",
            [("PART", 108), ("MARKER", 889), ("JOINT", 21), ("BEAM", 40), ("GRAPHICS", 317), ("VFORCE", 105)],
        ),
        (
            "bthornton191__adamspy/generic_model/generic_model.adm",
            [("PART", 3), ("MARKER", 12), ("JOINT", 2), ("BEAM", 0), ("GRAPHICS", 0), ("JPRIM", 1)],
        ),
    ] {
        let Some(text) = shared(path) else { return };
        let found = read_statements(&elements::registry(), FileId(0), &text);
        assert_eq!(found.diagnostics, [], "{path}");
        for (name, count) in counts {
            assert_eq!(found.count(name), count, "{path}: {name}");
        }
    }
}

/// Truth: the first beam of a public model, read with its numbers, and all of them complete.
#[test]
fn beams_of_an_export_are_read_with_their_arguments() {
    let Some(text) = shared("bthornton191__adamspy/real_analysis_with_spikes/FRS5_doe_8_LAUL_analysis.adm") else {
        return;
    };
    let found = read_statements(&elements::registry(), FileId(0), &text);
    assert_eq!(found.diagnostics, []);
    let beams: Vec<_> = found.statements.iter().filter(|s| s.name == "BEAM").collect();
    assert_eq!(beams.len(), 58);
    assert_eq!(beams[0].view_name.as_deref(), Some("s1_beamY_2"));
    assert_eq!(beams[0].id, Some(1));
    assert_eq!(beams[0].value("LENGTH", &text).as_deref(), Some("6.85449719"));
    assert_eq!(beams[0].value("EMODULUS", &text).as_deref(), Some("1.9E+05"));
    let complete = ["I", "J", "LENGTH", "IXX", "IYY", "IZZ", "AREA", "EMODULUS", "GMODULUS", "CRATIO", "FORMULATION"];
    assert!(beams.iter().all(|b| b.arguments.len() == 11 && complete.iter().all(|k| b.value(k, &text).is_some())));
}
