//! Names in run-time functions where objects of several classes share them: the function and the
//! argument decide.

use flexure_commands::{Interpreter, OnError, Report};
use model::Value;

/// A cantilever of two beams; `root` is a beam and a marker, `tip` a force and two markers.
const CANTILEVER: &str = "
model create model_name=cant
marker create marker_name=.cant.ground.root
part create rigid_body name_and_position part_name=.cant.n1
marker create marker_name=.cant.n1.cm
marker create marker_name=.cant.n1.tip location=500,0,0
part create rigid_body name_and_position part_name=.cant.n2 location=500,0,0
marker create marker_name=.cant.n2.cm location=500,0,0
marker create marker_name=.cant.n2.tip location=1000,0,0
force create element_like beam beam_name=.cant.b1 i_marker_name=.cant.n1.cm j_marker_name=.cant.ground.root &
  length=500 area=100 ixx=1600 iyy=800 izz=800 youngs=2E5 shear=8E4
force create element_like beam beam_name=.cant.root i_marker_name=.cant.n2.cm j_marker_name=.cant.n1.cm &
  length=500 area=100 ixx=1600 iyy=800 izz=800 youngs=2E5 shear=8E4
force create direct single_component_force single_component_force_name=.cant.tip type_of_freedom=translational &
  action_only=on i_marker_name=.cant.n2.tip j_marker_name=.cant.ground.root function=\"10\"
";

fn cantilever() -> Interpreter {
    let mut i = Interpreter::new(elements::registry());
    i.on_error = OnError::IgnoreCommand;
    let report = i.execute(CANTILEVER);
    assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
    i
}

fn request(i: &mut Interpreter, function: &str) -> (Report, String) {
    let report = i.execute(&format!("output_control create request request_name=.cant.r f2=\"{function}\""));
    let r = i.database.find(".cant.r", "request").unwrap();
    let text = match i.database.value(r, "f2") {
        Some(Value::Function(f)) => f.write(|id| format!("<{}>", i.database.full_name(id))),
        other => panic!("{other:?}"),
    };
    (report, text)
}

/// Truth: DY asks for markers, SFORCE for a force, BEAM for a beam (and a marker as its last
/// argument), whatever else has the name.
#[test]
fn the_argument_decides_which_of_several_objects_is_meant() {
    for (typed, bound) in [
        ("DY(n1.cm,root,root)", "DY(<.cant.n1.cm>,<.cant.ground.root>,<.cant.ground.root>)"),
        ("SFORCE(tip,0,3,0)", "SFORCE(<.cant.tip>,0,3,0)"),
        ("BEAM(root, 0, 2, root)", "BEAM(<.cant.root>, 0, 2, <.cant.ground.root>)"),
        ("STEP(DX(tip), 0, 0, 1, BEAM(b1,0,1))", "STEP(DX(<.cant.n2.tip>), 0, 0, 1, BEAM(<.cant.b1>,0,1))"),
        ("2*SFORCE(.cant.tip,0,3)", "2*SFORCE(<.cant.tip>,0,3)"),
    ] {
        let mut i = cantilever();
        let (report, text) = request(&mut i, typed);
        assert_eq!(text, bound);
        assert!(report.diagnostics.is_empty(), "{typed}: {:?}", report.diagnostics);
    }
}

/// What is of another class only is no match: the text stays, and who reads it is told why.
#[test]
fn a_name_of_another_class_is_not_taken() {
    for (typed, message, note) in [
        (
            "DX(.cant.root)",
            "the function names the marker `.cant.root`, which does not exist",
            "`.cant.root` is a Beam",
        ),
        ("DX(b1)", "the function names the marker `b1`, which does not exist", "`.cant.b1` is a Beam"),
        ("BEAM(.cant.tip,0,1)", "the function names the beam `.cant.tip`, which does not exist", "`.cant.tip` is a"),
    ] {
        let mut i = cantilever();
        let (report, text) = request(&mut i, typed);
        assert_eq!(text, typed);
        let [warning] = report.diagnostics.as_slice() else { panic!("{:?}", report.diagnostics) };
        assert_eq!((warning.code, warning.message.as_str()), ("name/not-found", message));
        assert!(warning.notes[0].starts_with(note), "{:?}", warning.notes);
    }
}

/// The current part decides between markers of one name; where it does not, nobody guesses.
#[test]
fn a_short_name_is_looked_up_in_the_current_part_first() {
    let mut i = cantilever();
    assert_eq!(request(&mut i, "DX(cm)").1, "DX(<.cant.n2.cm>)");
    let mut i = cantilever();
    i.execute("part create rigid_body name_and_position part_name=.cant.n3");
    let (report, text) = request(&mut i, "DX(cm)");
    assert_eq!(text, "DX(cm)");
    assert_eq!(report.diagnostics[0].code, "name/ambiguous");
    assert!(report.diagnostics[0].message.contains(".cant.n1.cm, .cant.n2.cm"), "{:?}", report.diagnostics);
}

/// A beam may take the name that a force of another class has, and what is written is read back as it
/// was.
#[test]
fn a_beam_may_share_its_name_with_a_force() {
    let mut i = cantilever();
    request(&mut i, "BEAM(b1,0,8,0)");
    let report = i.execute("force modify element_like beam beam_name=.cant.b1 new_beam_name=.cant.tip");
    assert!(!report.has_errors(), "{:?}", report.diagnostics);
    let written = i.write_model(i.database.find(".cant", "model").unwrap());
    let mut again = Interpreter::new(elements::registry());
    assert!(!again.execute(&written).has_errors());
    let r = again.database.find(".cant.r", "request").unwrap();
    let Some(Value::Function(f)) = again.database.value(r, "f2") else { panic!() };
    let classes: Vec<_> = f.objects().iter().map(|id| again.database.object(*id).class.id).collect();
    assert_eq!(classes, ["beam"]);
}

/// A force acts within its model.
#[test]
fn an_element_takes_no_marker_of_another_model() {
    let mut i = cantilever();
    let other = CANTILEVER.replace(".cant", ".other").replace("=cant", "=other");
    assert!(i.execute(&other).diagnostics.is_empty());
    let report = i.execute("force modify element_like beam beam_name=.cant.b1 j_marker_name=.other.ground.root");
    let [error] = report.diagnostics.as_slice() else { panic!("{:?}", report.diagnostics) };
    assert_eq!(error.code, "name/other-model");
    assert_eq!(error.message, "`.other.ground.root` belongs to the model `.other`, the beam to `.cant`");
    let b1 = i.database.find(".cant.b1", "beam").unwrap();
    let j = i.database.reference(b1, "j_marker_name").unwrap();
    assert_eq!(i.database.full_name(j), ".cant.ground.root");
}

/// Any object may be asked for: the complaint says so in words.
#[test]
fn messages_count_and_name_what_is_missing() {
    let mut i = cantilever();
    let said = |report: Report| report.diagnostics[0].message.clone();
    assert_eq!(
        said(i.execute("entity delete entity_name=.cant.nothing")),
        "there is no object `.cant.nothing`: `.cant` has no `nothing`"
    );
    assert_eq!(
        said(i.execute("marker delete marker_name=.cant.n2.tip")),
        "`.cant.n2.tip` cannot be deleted: 1 object refers to it"
    );
    let report = i.execute("force modify element_like beam beam_name=.cant.b1 youngs=2GPa");
    assert_eq!(report.diagnostics[0].code, "unit/unknown");
    assert!(report.diagnostics[0].helps[0].text.contains("pascal, megapascal"), "{report:?}");
}
