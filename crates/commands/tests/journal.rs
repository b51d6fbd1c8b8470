//! The journal: its layout, compared with logs that Adams wrote, and that it builds the same model
//! when it is read.

use std::path::{Path, PathBuf};

use flexure_commands::{Host, Interpreter, Journal, OnError, SimulationRequest, write_model};
use model::{Database, ObjectId};
use text::Diagnostic;

/// Says that every run went well.
struct Accepting;

impl Host for Accepting {
    fn simulate(&mut self, _: &mut Database, _: &SimulationRequest) -> Result<(), Vec<Diagnostic>> {
        Ok(())
    }

    fn write_data_set(&mut self, _: &mut Database, _: ObjectId, _: &Path) -> Result<(), Vec<Diagnostic>> {
        Ok(())
    }

    fn verify(&mut self, _: &Database, _: ObjectId) -> (Vec<String>, Vec<Diagnostic>) {
        (vec!["VERIFY MODEL: .m".into()], Vec::new())
    }
}

fn session() -> Interpreter {
    let mut interpreter = Interpreter::with_host(elements::registry(), Box::new(Accepting));
    interpreter.on_error = OnError::IgnoreCommand;
    interpreter.journal = Some(Journal::default());
    interpreter
}

fn journal_of(interpreter: &Interpreter) -> String {
    interpreter.journal.as_ref().unwrap().text()
}

/// The text behind the mark of an echoed line: `! +1&>   name = x`.
fn echoed(line: &str) -> Option<&str> {
    let text = line.strip_prefix("! ")?;
    let text = text.strip_prefix("ERROR:  ").unwrap_or(text);
    let text = text.trim_start_matches(|c: char| c == '+' || c == '-' || c.is_ascii_digit());
    let text = text.strip_prefix(">>").or_else(|| text.strip_prefix("&>"))?;
    Some(text.strip_prefix(' ').unwrap_or(text))
}

/// Lines of a log of which Flexure knows what they should be.
fn comparable(line: &&str) -> bool {
    echoed(line).is_some()
        || line.starts_with("! ERROR:")
        || line.contains("has mass but no")
        || line.contains("an IF, WHILE")
}

fn logs(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            logs(&path, found);
        } else if path.file_name().is_some_and(|n| n == "aview.log") {
            found.push(path);
        }
    }
}

/// Twin: logs that Adams View wrote while it read command files with mistakes in them. The files
/// are taken from the echoes; the journal of reading them must be the same, line by line.
#[test]
fn reading_a_file_is_logged_as_adams_does() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let mut found = Vec::new();
    logs(&Path::new(&shared).join("corpus"), &mut found);
    assert!(found.len() >= 8);
    let folder = std::env::temp_dir().join(format!("flexure-journal-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (mut compared, mut boxes) = (0, 0);
    for path in found {
        let log = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).replace('\r', "");
        let begin = "! Automatically executing Command file aview.cmd.\n";
        let Some((_, log)) = log.split_once(begin) else { continue };
        let until = log.find("! Command file is exhausted").unwrap_or(log.len());
        let wanted: Vec<&str> = log[..until].lines().filter(comparable).collect();
        let source: String = wanted.iter().filter_map(|l| echoed(l)).fold(String::new(), |s, l| s + l + "\n");
        let file = folder.join("aview.cmd");
        std::fs::write(&file, source).unwrap();
        let mut interpreter = session();
        let report = interpreter.run_file(&file);
        // What Adams says about a command that is not executed here cannot be known.
        let skipped = report.diagnostics.iter().filter(|d| d.code == "command/not-supported");
        let places = skipped.filter_map(|d| d.primary.as_ref());
        let first = places.map(|l| interpreter.sources.line_column(l.span.file, l.span.start).line).min();
        let journal = journal_of(&interpreter);
        let made: Vec<&str> = journal.lines().filter(comparable).collect();
        let mut source_line = 0;
        let known = wanted.iter().take_while(|l| {
            source_line += usize::from(echoed(l).is_some());
            first.is_none_or(|f| source_line < f)
        });
        let known = known.count();
        for (at, wanted) in wanted[..known].iter().enumerate() {
            assert_eq!(made.get(at), Some(wanted), "line {at} of {}", path.display());
        }
        assert!(first.is_some() || made.len() == wanted.len(), "{}", path.display());
        println!("{known} of {} lines: {}", wanted.len(), path.display());
        compared += 1;
        boxes += wanted[..known].iter().filter(|l| l.contains("Error detected")).count();
    }
    std::fs::remove_dir_all(&folder).unwrap();
    println!("{compared} logs, {boxes} errors");
    assert!(compared >= 6 && boxes >= 10, "{compared} logs, {boxes} errors");
}
/// Truth: the layout of command-language facts: `>>` and `&>` for first and further lines, the depth
/// of blocks before them and negative where lines are skipped; a box with line and character for
/// what could not be understood; messages behind the echo for what failed while it was executed.
#[test]
fn echoes_boxes_and_messages_have_their_layout() {
    let folder = std::env::temp_dir().join(format!("flexure-layout-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("part.cmd");
    let source = "! a model
model create &
   model_name = m

if condition = (1 > 2)
   view erase
else
   marker create marker_name = .m.ground.a
end
marker create &
   marker_name = .m.ground.b &
   locatoin = 1,2,3
undo forward
";
    std::fs::write(&file, source).unwrap();
    let mut i = session();
    i.run_file(&file);
    std::fs::remove_dir_all(&folder).unwrap();
    let rule = "! ERROR:  ---------------------------------------------------------------------";
    let wanted = format!(
        "! >> ! a model
! >> model create &
! &>    model_name = m
! >> 
! >> if condition = (1 > 2)
! -1>>    view erase
! -1>> else
! +1>>    marker create marker_name = .m.ground.a
! +1>> end
! >> marker create &
! &>    marker_name = .m.ground.b &
{rule}
! ERROR:  Error detected on line number 12, character 12 of part.cmd.
! ERROR:  'locatoin' is not a valid parameter.
! ERROR:  The command was not executed.
! ERROR:  &>    locatoin = 1,2,3
{rule}
! >> undo forward
! ERROR:  there is no step to do again
"
    );
    let journal = journal_of(&i);
    let (first, rest) = journal.split_once('\n').unwrap();
    assert!(first.starts_with("file command read file_name = ") && first.ends_with("part.cmd\""), "{first}");
    assert_eq!(rest, wanted);
}

/// What is typed, with mistakes in between.
const TYPED: [&str; 14] = [
    "defaults units length = meter",
    "model create model_name = m",
    "part create rigid_body name_and_position part_name = .m.p location = 1,0,0",
    "marker create &\n  marker_name = .m.p.a &\n  ! aside\n  location = 1,2,3",
    "marker create marker_name = .m.p.a",
    "marker creat marker_name = .m.p.q locatoin = 1,2,3",
    "variable set variable_name = n real_value = 3",
    "for variable_name = k start_value = 1 end_value = 5\n  if condition = (k > n)\n    break\n  end\n  marker create marker_name = (eval(\".m.p.k\" // RTOI(k))) location = (eval(k)), 0, 0\nend",
    "while condition = (nothing > 2)\n  marker create marker_name = .m.p.never\nend",
    "if condition = (n == 3)\n  marker create marker_name = .m.p.only\nelse\n  marker create marker_name = .m.p.not\nend",
    "macro create macro_name = add user_entered_command = \"add one\" commands_to_be_executed = \"marker create marker_name = $m:t=string\"",
    "add one m = .m.p.by_macro",
    "marker delete marker_name = .m.p.k2\nundo backward\nview erase",
    "entity modify entity_name = .m.p.a new_entity_name = renamed",
];

#[test]
fn a_journal_builds_the_same_model() {
    let mut i = session();
    i.on_error = OnError::AbortFile;
    for text in TYPED {
        i.execute(text);
    }
    let model = i.database.find(".m", "model").unwrap();
    let export = write_model(&i.database, model);
    for there in ["k1", "k2", "k3", "only", "by_macro", "renamed"] {
        assert!(export.contains(&format!(".m.p.{there}")), "{there} is missing");
    }
    for absent in ["k4", "never", ".not", ".q"] {
        assert!(!export.contains(absent), "{absent} exists");
    }
    let journal = journal_of(&i);
    let mut again = session();
    again.on_error = OnError::AbortFile;
    let report = again.run_text("journal", &journal);
    assert!(!report.has_errors(), "{:?}\n{journal}", report.diagnostics);
    let model = again.database.find(".m", "model").unwrap();
    assert_eq!(write_model(&again.database, model), export, "{journal}");
    assert!(journal.contains("'locatoin'") || journal.contains("'creat'"), "mistakes are on record:\n{journal}");
}

#[test]
fn all_passes_of_a_loop_are_echoed_if_asked_for() {
    let mut i = session();
    i.execute("model create model_name = m");
    let text = |all: &str| {
        format!("for variable_name = k start_value = 1 end_value = 3{all}\n  undo set steps_stored = 9\nend")
    };
    let echoes = |i: &Interpreter| journal_of(i).matches("! +1>>   undo set").count();
    i.execute(&text(""));
    assert_eq!(echoes(&i), 1);
    i.execute(&text(" echo_all_loops = yes"));
    assert_eq!(echoes(&i), 4);
}
