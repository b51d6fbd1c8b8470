//! Solver datasets read as models: what is written is read again as it was, comments stay, whatever is
//! wrong is named with its place, and nothing else is lost.

#[path = "datasets/comments.rs"]
mod comments;
#[path = "datasets/hostile.rs"]
mod hostile;
#[path = "datasets/kept.rs"]
mod kept;
#[path = "datasets/public.rs"]
mod public;
#[path = "datasets/units.rs"]
mod units;
#[path = "datasets/wrong.rs"]
mod wrong;

use std::path::{Path, PathBuf};

use flexure::{Analysis, Outputs, Run, Session, SimulationOptions};
use tempfile::TempDir;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Files below a folder with an ending, in order of their names.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The public models, where they are at hand.
fn corpus() -> Option<PathBuf> {
    let shared = std::env::var_os("FLEXURE_SHARED");
    if shared.is_none() {
        println!("skipped: FLEXURE_SHARED is not set");
    }
    shared.map(|shared| PathBuf::from(shared).join("corpus"))
}

fn quiet() -> Session {
    let mut session = Session::new();
    session.simulate_nothing(true);
    session
}

fn read(path: &Path) -> Session {
    let mut session = quiet();
    let report = session.read(path);
    assert!(!report.has_errors(), "{}\n{}", path.display(), session.render(&report.diagnostics, false));
    session
}

struct Desk {
    folder: TempDir,
}

impl Desk {
    fn new() -> Desk {
        Desk { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.path(name);
        std::fs::write(&path, text).unwrap();
        path
    }

    /// The model of a session as text of a file of that name.
    fn written(&self, session: &mut Session, name: &str) -> String {
        let path = self.path(name);
        session.write(&path).unwrap_or_else(|e| panic!("{e:#?}"));
        std::fs::read_to_string(path).unwrap()
    }
}

/// What of a dataset a model read from it must say again: everything, or the statements alone where
/// something is only a comment, which that model does not hold.
fn said(text: &str, whole: bool) -> Vec<&str> {
    text.lines().filter(|line| whole || !line.starts_with('!')).collect()
}

/// Writes, reads and writes again; the number of statements written.
fn round(session: &mut Session, what: &str) -> usize {
    let desk = Desk::new();
    let first = desk.written(session, "first.adm");
    let mut again = quiet();
    let report = again.read(&desk.path("first.adm"));
    assert!(!report.has_errors(), "{what}\n{}", again.render(&report.diagnostics, false));
    let second = desk.written(&mut again, "second.adm");
    let whole = !first.contains("\n! not written: ");
    let (ours, theirs) = (said(&second, whole), said(&first, whole));
    for (line, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
        assert_eq!(ours, theirs, "{what}: line {}", line + 1);
    }
    assert_eq!(ours.len(), theirs.len(), "{what}");
    let mut third = read(&desk.path("second.adm"));
    assert_eq!(desk.written(&mut third, "third.adm"), second, "{what}");
    first.lines().filter(|line| line.contains('/') && !line.starts_with(['!', ','])).count()
}

/// Commands behind `mechanisms/beams/beams.cmd` that build chains of beams as the mechanisms do.
const CHAINS: [&str; 4] = [
    "chain n=4 formulation=linear\ntip moment size=3.141592653589793\n",
    "chain n=3 formulation=string\ntip force x=\"0\" y=\"-0.1*TIME\" z=\"1E-3\"\n",
    "chain n=2 formulation=nonlinear ea=1e9 rotary_y=1e-10 rotary_z=1e-10 polar=1e-10 turn=\"6*time\"\n",
    "chain n=1 formulation=linear\ntip torque size=0.25\n",
];

#[test]
fn our_models_are_written_the_same_after_they_were_read() {
    let mut rounds = 0;
    for path in ["examples", "mechanisms"].iter().flat_map(|folder| files(&root().join(folder), "cmd")) {
        let mut session = quiet();
        let report = session.read(&path);
        assert!(!report.has_errors(), "{}", path.display());
        if session.model().is_some() {
            round(&mut session, &path.display().to_string());
            rounds += 1;
        }
    }
    for chain in CHAINS {
        let mut session = quiet();
        session.read(&root().join("mechanisms/beams/beams.cmd"));
        let report = session.execute(chain);
        assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
        assert!(round(&mut session, chain) > 8);
        rounds += 1;
    }
    assert!(rounds >= 9, "{rounds}");
}

fn dynamic(session: &mut Session) -> Run {
    let analysis = Analysis::Dynamic { end: 0.2, outputs: Outputs::Steps(20) };
    session.simulate(&SimulationOptions::new(analysis)).unwrap_or_else(|e| panic!("{e:#?}"))
}

/// What rounding may become in 20 output steps, as a part of the largest value of a series: a part in 1E16 in
/// each of some thousand sums.
const ROUNDING: f64 = 1e-13;

/// Twin: the run of the command file. The dataset has every digit, so that both are the same but for
/// the order of sums where the order of objects is another.
#[test]
fn a_model_runs_the_same_from_its_dataset() {
    for name in ["rotor", "cantilever"] {
        let desk = Desk::new();
        let mut from_commands = read(&root().join("examples").join(name).join(format!("{name}.cmd")));
        from_commands.write(&desk.path("model.adm")).unwrap();
        let mut from_dataset = read(&desk.path("model.adm"));
        for session in [&mut from_commands, &mut from_dataset] {
            session.simulate_nothing(false);
        }
        let (expected, found) = (dynamic(&mut from_commands), dynamic(&mut from_dataset));
        assert_eq!(expected.table.series.len(), found.table.series.len());
        assert!(expected.table.series.len() > 10);
        for series in &expected.table.series {
            let twin = found.table.get(&series.name).unwrap_or_else(|| panic!("no {}", series.name));
            let largest = series.values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            for (a, b) in series.values.iter().zip(&twin.values) {
                assert!((a - b).abs() <= ROUNDING * largest, "{name} {}: {a} and {b}", series.name);
            }
        }
    }
}

/// A dataset as people write it: abbreviated words, any case, Fortran numbers, several arguments in a
/// line, expressions that go on, and statements in any order.
const BY_HAND: &str = "Adams View model name: hand
UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=METER,TIME=SECOND
joint/3, revolute, i=201, j = 1
part/02, mass=2., cm = 0201 , ip=.5 , 1E0, 1.0E+00
, qg = 1, 0, 0, reu = 90D, 0, 0
MARKER/0201,PART=2
MARKER/1, PA=1
PART/1,GROUND
MARKER/5, PART=1, FLOATING
VAR/1, FUN = 2*
, TIME
VFORCE/1, I=201, JFLOAT=5, RM=1, FX = STEP(TIME, 0, 0,
, 1, VARVAL(1))\\, FY = 0\\
, FZ=-1*DZ(201, 1)
SFORCE/7, ROT, I=201, J=1, ACTIONONLY, FUNCTION = 30D*TIME
ACCG/KGRAV=-9.81
INT/HHT, ERR=1E-6
END
nothing here is read
";

#[test]
fn a_dataset_by_hand_is_understood() {
    let desk = Desk::new();
    let session = read(&desk.put("hand.adm", BY_HAND));
    let value = |object: &str, name: &str| {
        let found = session.attribute(object, name).unwrap_or_else(|| panic!("{object} has no {name}"));
        format!("{:?}", found.value)
    };
    assert_eq!(session.model_name().as_deref(), Some("hand"));
    assert!(value(".hand.PART_2", "mass").contains("2.0"));
    assert!(value(".hand.PART_2", "ixx").contains("0.5"));
    assert!(value(".hand.PART_2", "orientation").contains("90.0"));
    assert!(value(".hand.JOINT_3", "i_marker_name").contains(".hand.PART_2.MARKER_201"));
    let place = value(".hand.PART_2", "location");
    assert!(place.contains("[1.0, 0.0, 0.0]"), "{place}");
    for (object, name, expected) in [
        (".hand.VARIABLE_1", "function", "2* TIME"),
        (".hand.VFORCE_1", "x_force_function", "STEP(TIME, 0, 0, 1, VARVAL(.hand.VARIABLE_1))"),
        (".hand.VFORCE_1", "y_force_function", "0"),
        (".hand.VFORCE_1", "z_force_function", "-1*DZ(.hand.PART_2.MARKER_201, .hand.ground.MARKER_1)"),
        (".hand.SFORCE_7", "function", "30D*TIME"),
    ] {
        let found = value(object, name);
        assert!(found.contains(&format!("\"{expected}\"")), "{object}: {found}");
    }
    assert!(value(".hand.SFORCE_7", "type_of_freedom").contains("rotational"));
    assert!(value(".hand.gravity", "z_component_gravity").contains("-9.81"));
    assert_eq!(session.database().units().length.name, "meter");
}

/// The command is in the journal, one step takes it back, and running it again gives the same model.
#[test]
fn reading_is_one_command() {
    let desk = Desk::new();
    let path = desk.put("hand.adm", BY_HAND);
    let mut session = quiet();
    session.keep_journal(&desk.path("journal.cmd")).unwrap();
    let report = session.read(&path);
    assert_eq!((report.executed, report.failed), (1, 0), "{}", session.render(&report.diagnostics, false));
    let units = session.database().units().length.name;
    let text = desk.written(&mut session, "first.cmd");
    assert!(session.undo());
    assert_eq!(session.model(), None);
    assert_eq!((session.database().units().length.name, units), ("mm", "meter"));
    assert!(session.redo());
    assert_eq!(desk.written(&mut session, "again.cmd"), text);
    let mut replayed = quiet();
    let report = replayed.read(&desk.path("journal.cmd"));
    assert!(!report.has_errors(), "{}", replayed.render(&report.diagnostics, false));
    assert_eq!(desk.written(&mut replayed, "replayed.cmd"), text);
}

#[test]
fn the_command_names_the_model_and_gives_units_where_the_file_has_none() {
    let desk = Desk::new();
    let path = desk.put("plain.adm", "a title\nPART/1,GROUND\nPART/2,MASS=1\nEND\n");
    let mut session = quiet();
    let command = format!("file adams_data_set read file_name=\"{}\" model_name=.other length=foot", path.display());
    let report = session.execute(&command);
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    assert_eq!(session.model_name().as_deref(), Some("other"));
    assert_eq!(session.database().units().length.name, "foot");
    assert!(session.attribute(".other", "title").is_some());
    // The same name a second time.
    let again = session.execute(&command);
    assert!(again.failed == 1 && again.diagnostics[0].code == "dataset/model-exists", "{:#?}", again.diagnostics);
    // Without a name in title or command, that of the file.
    session.read(&path);
    assert_eq!(session.model_name().as_deref(), Some("plain"));
}

#[test]
fn a_dataset_is_read_into_a_model_that_exists() {
    let desk = Desk::new();
    let path = desk.put("plain.adm", "a title\nUNITS/LENGTH=METER\nPART/1,GROUND\nPART/2,MASS=1,QG=1,0,0\nEND\n");
    let mut session = quiet();
    session.execute("model create model_name=.here");
    let report =
        session.execute(&format!("file adams_data_set merge file_name=\"{}\" model_name=.here", path.display()));
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    assert_eq!(session.database().units().length.name, "mm");
    let place = session.attribute(".here.PART_2", "location").unwrap();
    assert!(format!("{:?}", place.value).contains("1000.0"), "{:?}", place.value);
}
