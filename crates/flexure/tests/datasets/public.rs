//! Public datasets, written by Adams View and by other programs.

use std::collections::BTreeMap;
use std::path::Path;

use flexure::Session;
use model::{Database, ObjectId};

use super::{Desk, corpus, files, quiet, round};

/// Ten digits leave seven decimals of an angle of 100 degrees and more: half of the last is 9E-10 rad, in each
/// of three angles and in either file.
const ROTATION: f64 = 6.0 * 9e-10;

/// The models of public files, whatever of them Flexure holds.
#[test]
fn public_models_are_written_the_same_after_they_were_read() {
    let Some(corpus) = corpus() else { return };
    let (mut rounds, mut statements) = (0, 0);
    for path in files(&corpus, "cmd").into_iter().chain(files(&corpus, "adm")) {
        let mut session = quiet();
        session.read(&path);
        let desk = Desk::new();
        let Some(model) = session.model_name() else { continue };
        if let Err(troubles) = session.write(&desk.path("probe.adm")) {
            println!("{} of {}: {}", model, path.display(), troubles[0].message);
            continue;
        }
        statements += round(&mut session, &path.display().to_string());
        rounds += 1;
    }
    println!("{rounds} models, {statements} statements");
    assert!(rounds >= 19 && statements > 12_000, "{rounds} {statements}");
}

fn text(path: &Path) -> String {
    String::from_utf8_lossy(&std::fs::read(path).unwrap()).replace('\r', "")
}

/// Truth: the statements, counted as lines that begin with their names.
#[test]
fn public_datasets_are_read_to_the_end() {
    let Some(corpus) = corpus() else { return };
    let paths = files(&corpus, "adm");
    assert_eq!(paths.len(), 8);
    for path in paths {
        let mut session = quiet();
        let report = session.read(&path);
        let flexible = report.diagnostics.iter().filter(|d| d.message.ends_with("its body is flexible")).count();
        let errors: Vec<_> = report.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(errors.is_empty(), "{}\n{errors:#?}", path.display());
        let model = session.model().unwrap();
        let database = session.database();
        let text = text(&path);
        let count = |statement: &str| {
            text.lines().filter(|l| l.strip_prefix(statement).is_some_and(|rest| rest.starts_with('/'))).count()
        };
        for (statement, families, unread) in [
            ("PART", &["part"][..], 0),
            ("MARKER", &["marker", "floating_marker"], flexible),
            ("JOINT", &["joint"], 0),
            ("JPRIM", &["primitive_joint"], 0),
            ("BEAM", &["beam"], 0),
            ("FIELD", &["field"], 0),
            ("VFORCE", &["force_vector"], 0),
            ("GFORCE", &["general_force"], 0),
            ("VARIABLE", &["solver_variable"], 0),
            ("REQUEST", &["request"], 0),
        ] {
            let found: usize = families.iter().map(|family| database.below(model, family).len()).sum();
            assert_eq!(found, count(statement) - unread, "{statement} of {}", path.display());
        }
        println!("{}: {} warnings", path.display(), report.diagnostics.len());
    }
}

/// Truth: an export of Adams View, which the command writes again to the byte.
#[test]
fn the_generic_model_comes_back_byte_for_byte() {
    let Some(corpus) = corpus() else { return };
    let path = corpus.join("bthornton191__adamspy/generic_model/generic_model.adm");
    let desk = Desk::new();
    let mut session = quiet();
    session.read(&path);
    let again = desk.path("again.adm");
    session.execute(&format!("file adams_data_set write file_name = \"{}\"", again.display()));
    assert_eq!(text(&again).trim_end(), text(&path).trim_end());
}

/// Twin: the command file of the same model, from the same export. Both have ten digits.
#[test]
fn datasets_agree_with_the_command_files_of_their_models() {
    let Some(corpus) = corpus() else { return };
    let commands: Vec<_> = files(&corpus, "cmd");
    let (mut models, mut beams, mut parts) = (0, 0, 0);
    for path in files(&corpus, "adm") {
        let mut dataset = quiet();
        dataset.read(&path);
        let name = dataset.model_name().unwrap();
        for twin in commands.iter().filter(|c| c.parent() == path.parent()) {
            let mut session = quiet();
            session.read(twin);
            let Some(model) = session.database().find(&format!(".{name}"), "model") else { continue };
            if name == "MODEL_1" {
                continue; // every new model is called that
            }
            let (b, p) = compare(&dataset, &session, model, twin);
            (models, beams, parts) = (models + 1, beams + b, parts + p);
        }
    }
    println!("{models} models, {beams} beams, {parts} parts");
    assert!(models >= 2 && beams >= 40 && parts >= 100, "{models} {beams} {parts}");
}

fn by_name(database: &Database, model: ObjectId, family: &str) -> BTreeMap<String, ObjectId> {
    database.below(model, family).into_iter().map(|id| (database.object(id).name.to_lowercase(), id)).collect()
}

fn close(a: f64, b: f64, what: &str) {
    // Numbers in the same units. A command file has ten digits or more, of which half the last is at most a
    // part in 2E9; a dataset has no more than ten decimals, of which half the last is 5E-11.
    assert!((a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 6e-11, "{what}: {a} and {b}");
}

fn compare(dataset: &Session, commands: &Session, model: ObjectId, path: &Path) -> (usize, usize) {
    let (a, b) = (dataset.database(), commands.database());
    let (mut beams, mut parts) = (0, 0);
    let theirs = by_name(b, model, "beam");
    for (name, id) in by_name(a, dataset.model().unwrap(), "beam") {
        let Some(twin) = theirs.get(&name) else { panic!("{}: no beam {name}", path.display()) };
        for cell in [
            "length",
            "ixx",
            "iyy",
            "izz",
            "area_of_cross_section",
            "y_shear_area_ratio",
            "z_shear_area_ratio",
            "youngs_modulus",
            "shear_modulus",
            "damping_ratio",
        ] {
            let values = [a.number(id, cell), b.number(*twin, cell)].map(|x| x.unwrap_or(f64::NAN));
            close(values[0], values[1], &format!("{name} {cell}"));
        }
        assert_eq!(a.text(id, "formulation"), b.text(*twin, "formulation"));
        beams += 1;
    }
    let theirs = by_name(b, model, "part");
    for (name, id) in by_name(a, dataset.model().unwrap(), "part") {
        let Some(twin) = theirs.get(&name) else { continue };
        let (ours, other) = (a.global_pose(id), b.global_pose(*twin));
        assert!(ours.rotation.abs_diff_eq(other.rotation, ROTATION), "{name}");
        for k in 0..3 {
            close(ours.origin[k], other.origin[k], &format!("{name} location"));
        }
        // Where the command file has no mass, it follows from shapes.
        if let Some(mass) = b.number(*twin, "mass") {
            close(a.number(id, "mass").unwrap_or(f64::NAN), mass, &format!("{name} mass"));
            for cell in ["ixx", "iyy", "izz"] {
                let values = [a.number(id, cell), b.number(*twin, cell)].map(|x| x.unwrap_or(0.0));
                close(values[0], values[1], &format!("{name} {cell}"));
            }
        }
        parts += 1;
    }
    (beams, parts)
}
