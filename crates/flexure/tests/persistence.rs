//! Models in `.fx` files: what is saved is what is opened, whatever happens to the process or the file.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use flexure::{Report, Session};
use proptest::prelude::*;
use tempfile::TempDir;

const SCENE: &str = "\
model create model_name = m title = \"with \\\"quotes\\\" and \u{e4}\"
part create rigid_body name_and_position part_name = .m.a location = 10,20,30 comments = \"first\", \"second\"
marker create marker_name = .m.a.cm location = 1,2,3 orientation = 10,20,30
part create rigid_body mass_properties part_name = .m.a mass = 1.5 center_of_mass_marker = .m.a.cm ixx=1 iyy=2 izz=2.5
variable set variable_name = .m.len real_value = 0.1 units = length
variable set variable_name = .m.sum real_value = (.m.len * 3 + 1 - 2 * PI)
marker create marker_name = .m.ground.r location = (.m.len), 0, (LOC_RELATIVE_TO({0, 0, .m.sum}, .m.a.cm)[3])
force create element_like beam beam_name = .m.b i_marker_name = .m.a.cm j_marker_name = .m.ground.r length = (.m.sum + 20)
group create group_name = .m.g objects_in_group = .m.a, .m.b
floating_marker create floating_marker_name = .m.ground.not_executed
macro create macro_name = .mdi.mk user_entered_command = \"mk one\" commands_to_be_executed = \"!$n:t=string:ud=zzz\", \"marker create marker_name = $n\"
mk one n = .m.a.by_macro
defaults units length = inch
defaults coordinate_system default_coordinate_system = .m.a
";

fn ok(report: &Report) {
    assert!(!report.has_errors(), "{:#?}", report.diagnostics);
}

fn session(text: &str) -> Session {
    let mut session = Session::new();
    ok(&session.execute(text));
    session
}

fn opened(path: &Path) -> Session {
    let mut session = Session::new();
    session.open(path).unwrap_or_else(|d| panic!("{d:#?}"));
    session
}

/// Everything that can be seen of a session: its models as commands, objects with numbers, cells and
/// expressions, settings.
fn seen(session: &mut Session, folder: &TempDir) -> (Vec<String>, String, String) {
    let path = folder.path().join("seen.cmd");
    let export = match session.model() {
        Some(_) => {
            session.write(&path).unwrap();
            fs::read_to_string(&path).unwrap()
        }
        None => String::new(),
    };
    let database = session.database();
    let objects = database.ids().map(|id| format!("{:?}", database.stored(id))).collect();
    (objects, format!("{:?} {:?}", database.settings(), database.unit_systems()), export)
}

fn codes(outcome: Result<(), Vec<flexure::text::Diagnostic>>) -> Vec<&'static str> {
    outcome.err().into_iter().flatten().map(|d| d.code).collect()
}

#[test]
fn what_is_written_is_what_is_read() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    let mut first = session(SCENE);
    first.write(&path).unwrap();
    let mut second = Session::new();
    ok(&second.read(&path));
    assert_eq!(seen(&mut second, &folder), seen(&mut first, &folder));
    assert!(seen(&mut second, &folder).2.contains(".m.ground.not_executed"), "skipped commands are kept");
    // The user's command, its changed default, the units and the place of new objects are back too.
    for session in [&mut first, &mut second] {
        ok(&session.execute("marker delete marker_name = .m.a.by_macro"));
        ok(&session.execute("mk one"));
        ok(&session.execute("marker create marker_name = .m.ground.next location = 1,1,1"));
        ok(&session.execute("variable modify variable_name = .m.len real_value = 2"));
    }
    assert_eq!(seen(&mut second, &folder), seen(&mut first, &folder));
    assert!(second.resolve(".m.a.by_macro", "marker").is_some());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "a file at rest is one file");
}

#[test]
fn a_session_that_is_followed_comes_back_as_it_was_left() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    let mut first = session("model create model_name = m");
    first.save_as(&path).unwrap();
    for line in SCENE.lines().skip(1) {
        ok(&first.execute(line));
    }
    for line in [
        "undo backward",
        "marker delete marker_name = .m.a.by_macro",
        "entity modify entity_name = .m.a new_entity_name = renamed",
        "undo backward",
        "undo forward",
        "marker create marker_name = .m.ground.r",
    ] {
        first.execute(line);
    }
    let left = seen(&mut first, &folder);
    drop(first);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "no log and no lock stay behind");
    assert_eq!(seen(&mut opened(&path), &folder), left);
}

#[test]
fn a_second_session_is_told_who_holds_the_file() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    let mut first = session(SCENE);
    first.save_as(&path).unwrap();
    let refused = Session::new().open(&path).unwrap_err();
    assert_eq!(refused[0].code, "store/in-use");
    let process = format!("process {}", std::process::id());
    assert!(refused[0].message.contains(&process), "{}", refused[0].message);
    let mut other = session("model create model_name = other");
    assert_eq!(codes(other.write(&path).map(|_| ())), ["store/in-use"]);
    // To look into it is allowed meanwhile, and shows all that was accepted.
    ok(&first.execute("marker create marker_name = .m.ground.late"));
    let mut looking = Session::new();
    ok(&looking.read(&path));
    assert!(looking.resolve(".m.ground.late", "marker").is_some());
    drop(first);
    opened(&path);
}

#[test]
fn a_file_goes_into_a_session_that_has_a_model_as_commands() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    session("model create model_name = m\nmarker create marker_name = .m.ground.k").write(&path).unwrap();
    let mut other = session("model create model_name = other");
    assert_eq!(codes(other.open(&path)), ["store/session-begun"]);
    ok(&other.read(&path));
    assert!(other.resolve(".m.ground.k", "marker").is_some() && other.resolve(".other", "model").is_some());
}

#[test]
fn what_is_no_model_of_ours_is_refused_by_name() {
    let folder = TempDir::new().unwrap();
    let file = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let good = folder.path().join("good.fx");
    session(SCENE).write(&good).unwrap();
    let bytes = fs::read(&good).unwrap();
    // Truth: the layout of SQLite's header: the mark of the application at 68, its version at 60.
    let (mut foreign, mut newer) = (bytes.clone(), bytes.clone());
    foreign[68..72].copy_from_slice(&[0; 4]);
    newer[60..64].copy_from_slice(&99u32.to_be_bytes());
    for (path, wanted) in [
        (folder.path().join("absent.fx"), "store/cannot-open"),
        (file("empty.fx", b""), "store/not-a-model"),
        (file("text.fx", &b"model create model_name = m\n".repeat(99)), "store/not-a-model"),
        (file("foreign.fx", &foreign), "store/not-a-model"),
        (file("newer.fx", &newer), "store/newer-version"),
    ] {
        assert_eq!(codes(Session::new().open(&path)), [wanted], "{}", path.display());
        let mut session = Session::new();
        assert_eq!(session.read(&path).diagnostics[0].code, wanted);
        assert!(session.model().is_none());
    }
}

/// A damaged file is refused, or it is whole: bytes that no row uses may change.
#[test]
fn a_damaged_file_is_reported_or_whole() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    let mut first = session(SCENE);
    first.write(&path).unwrap();
    let (bytes, whole) = (fs::read(&path).unwrap(), seen(&mut first, &folder));
    let spoilt = folder.path().join("spoilt.fx");
    let (mut refused, mut tried) = (0, 0);
    let mut try_it = |bytes: &[u8], what: String| {
        fs::write(&spoilt, bytes).unwrap();
        let mut session = Session::new();
        let report = session.read(&spoilt);
        tried += 1;
        if report.has_errors() {
            refused += 1;
            let code = report.diagnostics[0].code;
            assert!(code.starts_with("store/"), "{what}: {code}");
            assert!(session.model().is_none(), "{what}: half read");
        } else {
            assert_eq!(seen(&mut session, &folder), whole, "{what}");
        }
    };
    for length in (0..bytes.len()).step_by(bytes.len() / 23) {
        try_it(&bytes[..length], format!("cut at {length}"));
    }
    // A step that is no multiple of a page's size meets headers, contents and gaps.
    for at in (0..bytes.len()).step_by(bytes.len() / 211) {
        let mut changed = bytes.clone();
        changed[at] ^= 0x10;
        try_it(&changed, format!("byte {at}"));
    }
    // A file as small as this one is gaps for the most part.
    assert!(refused * 4 > tried, "{refused} of {tried} were refused");
}

/// Truth: a value that was changed behind our back differs from its row's checksum; a row that went
/// or came is missed by the seal.
#[test]
fn a_value_changed_by_another_program_is_noticed() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    session("model create model_name = m\nvariable set variable_name = .m.v string_value = \"needle\"")
        .write(&path)
        .unwrap();
    let mut bytes = fs::read(&path).unwrap();
    let at = bytes.windows(6).position(|w| w == b"needle").unwrap();
    bytes[at] = b'N';
    fs::write(&path, &bytes).unwrap();
    let mut session = Session::new();
    let report = session.read(&path);
    assert_eq!(report.diagnostics[0].code, "store/damaged");
    assert!(report.diagnostics[0].notes[0].contains("`v`"), "{:?}", report.diagnostics[0].notes);
}

// ---- killed processes ----

const CHILD: &str = "FLEXURE_TEST_CHILD";

/// Not a test of its own: what the process does that is killed.
#[test]
fn child_that_is_killed() {
    let Some(path) = std::env::var_os(CHILD) else { return };
    let mut session = opened(&PathBuf::from(path));
    let first = session.objects("marker").len();
    for number in first.. {
        ok(&session.execute(&format!("marker create marker_name = .m.ground.k{number} location = {number},0,0")));
        println!("accepted {number}");
        std::io::stdout().flush().unwrap();
    }
}

#[test]
fn a_killed_process_loses_nothing_it_has_acknowledged() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("m.fx");
    session("model create model_name = m").write(&path).unwrap();
    let mut total = 0;
    // Numbers of commands after which the process is killed, in the middle of the next ones.
    for rounds in [1, 17, 3, 40, 8] {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["child_that_is_killed", "--exact", "--nocapture", "--test-threads=1"])
            .env(CHILD, &path)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(child.stdout.take().unwrap()).lines().map_while(Result::ok);
        let mut acknowledged =
            lines.filter_map(|l| l.rsplit_once("accepted ").and_then(|(_, n)| n.parse::<usize>().ok()));
        let mut last = acknowledged.by_ref().take(rounds).last().unwrap();
        child.kill().unwrap();
        // What it has said before it died counts too.
        last = acknowledged.last().unwrap_or(last);
        child.wait().unwrap();
        let session = opened(&path);
        let found = session.objects("marker");
        assert!(found.len() == last + 1 || found.len() == last + 2, "{last} acknowledged, {} found", found.len());
        for number in 0..=last {
            assert!(found.contains(&format!(".m.ground.k{number}")), "k{number} is lost");
        }
        total = found.len();
    }
    assert!(total >= 69);
}

// ---- any sequence of commands ----

fn command() -> impl Strategy<Value = String> {
    let name = prop::sample::select(vec!["a", "b", "c"]);
    let number = prop::sample::select(vec!["0", "1.5", "-2.25E-7", "(.m.v + 1)", "(.m.w * 2)", "0.1", "1E300"]);
    let unit = prop::sample::select(vec!["mm", "inch", "meter"]);
    prop_oneof![
        (name.clone(), number.clone()).prop_map(|(n, x)| format!(
            "part create rigid_body name_and_position part_name = .m.{n} location = {x}, 1, 2"
        )),
        (name.clone(), name.clone(), number.clone())
            .prop_map(|(p, n, x)| format!("marker create marker_name = .m.{p}.{n} location = 0, {x}, 0")),
        (name.clone(), name.clone())
            .prop_map(|(p, n)| format!("marker modify marker_name = .m.{p}.{n} orientation = 1,2,3")),
        (name.clone(), name.clone()).prop_map(|(p, n)| format!("marker delete marker_name = .m.{p}.{n}")),
        (name.clone(), name.clone())
            .prop_map(|(p, n)| format!("entity modify entity_name = .m.{p} new_entity_name = {n}")),
        number.clone().prop_map(|x| format!("variable set variable_name = .m.v real_value = {x}")),
        number.clone().prop_map(|x| format!("variable set variable_name = .m.w real_value = {x}")),
        Just("variable delete variable_name = .m.w".to_string()),
        unit.prop_map(|u| format!("defaults units length = {u}")),
        name.clone().prop_map(|n| format!("defaults coordinate_system default_coordinate_system = .m.{n}")),
        name.clone().prop_map(|n| format!("part delete part_name = .m.{n}")),
        (name.clone(), name.clone())
            .prop_map(|(p, n)| format!("floating_marker create floating_marker_name = .m.{p}.F{n}")),
        Just("undo backward".to_string()),
        Just("undo forward".to_string()),
        Just("for variable_name = i start_value = 1 end_value = 3\nmarker create\nend".to_string()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Twin: the session itself, command by command saved, against the file opened and written anew.
    #[test]
    fn any_session_is_what_its_file_opens_to(commands in prop::collection::vec(command(), 1..40)) {
        let folder = TempDir::new().unwrap();
        let (followed, whole) = (folder.path().join("followed.fx"), folder.path().join("whole.fx"));
        let mut first = session("model create model_name = m");
        first.save_as(&followed).unwrap();
        for command in &commands {
            first.execute(command);
        }
        let left = seen(&mut first, &folder);
        first.write(&whole).unwrap();
        drop(first);
        for path in [&followed, &whole] {
            prop_assert_eq!(&seen(&mut opened(path), &folder), &left, "{}", path.display());
        }
    }
}
