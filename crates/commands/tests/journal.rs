//! The journal: its layout, and that it builds the same model when it is read.

use std::path::Path;

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

/// Truth: lines that are read are echoed as they stand, comments too (command-language facts, 12).
#[test]
fn comments_of_a_macro_are_echoed_as_they_stand() {
    let mut i = session();
    i.execute(
        "macro create macro_name = say user_entered_command = \"say it\" commands_to_be_executed = &\n  \
         \"!$x:t=real:d=1\", \"! what for\", \"variable set variable_name = v real_value = $x\"",
    );
    let before = journal_of(&i).lines().count();
    i.execute("say it x = 2");
    let journal = journal_of(&i);
    let echoes: Vec<&str> = journal.lines().skip(before).collect();
    let expected = [
        "say it x = 2",
        "! >> say it x = 2",
        "! >> !$x:t=real:d=1",
        "! >> ! what for",
        "! >> variable set variable_name = v real_value = 2",
    ];
    assert_eq!(echoes, expected);
}
