//! Comments: of the model, of objects, and what is none.

use super::{Desk, quiet, read};
use flexure::Session;

/// A beam from ground to a part, with the comments given.
fn commented(model: &[&str], beam: &[&str], marker: &[&str]) -> Session {
    let list = |texts: &[&str]| {
        let quoted: Vec<String> = texts.iter().map(|t| format!("\"{}\"", t.replace('"', "\\\""))).collect();
        if quoted.is_empty() { String::new() } else { format!(" comments = {}", quoted.join(", ")) }
    };
    let mut session = quiet();
    let report = session.execute(&format!(
        "model create model_name = m{}\n\
         marker create marker_name = .m.ground.j location = 0, 0, 0{}\n\
         part create rigid_body name_and_position part_name = .m.bar location = 100, 0, 0\n\
         marker create marker_name = .m.bar.cm location = 100, 0, 0\n\
         part create rigid_body mass_properties part_name = .m.bar mass = 1 center_of_mass_marker = .m.bar.cm \
         ixx = 1 iyy = 1 izz = 1\n\
         force create element_like beam beam_name = .m.b i_marker_name = .m.bar.cm j_marker_name = .m.ground.j \
         length = 100 ixx = 2 iyy = 1 izz = 1 area_of_cross_section = 1 youngs_modulus = 2e5 shear_modulus = 8e4{}\n",
        list(model),
        list(marker),
        list(beam)
    ));
    assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
    session
}

fn comments(session: &Session, object: &str) -> Vec<String> {
    let database = session.database();
    let id = database.find(object, "any").unwrap();
    match database.value(id, "comments") {
        Some(model::Value::Texts(texts)) => texts.clone(),
        Some(model::Value::Text(text)) => vec![text.clone()],
        _ => Vec::new(),
    }
}

const ODD: &[&str] = &[
    "two lines,",
    "   the second one further in",
    "",
    "it's 'quoted' and behind a blank line",
    "BEAM/7",
    ", I = 2",
    "-------- a line --------",
    "=====",
    "not written: this is",
    "adams_view_name='another'",
    "! with a mark",
    "END",
    "",
];

/// `.cmd -> .adm -> .cmd`, and back again.
#[test]
fn comments_survive_both_ways() {
    let desk = Desk::new();
    let mut first = commented(&["of the model", "", "END OF MODEL COMMENTS", " more"], ODD, &["on the ground"]);
    let commands = desk.written(&mut first, "first.cmd");
    let dataset = desk.written(&mut first, "first.adm");
    assert!(dataset.contains("\n! of the model\n! \n! END OF MODEL COMMENTS\n!  more\n!\n"));
    let mut second = read(&desk.path("first.adm"));
    for object in [".m", ".m.b", ".m.ground.j", ".m.bar"] {
        assert_eq!(comments(&second, object), comments(&first, object), "{object}");
    }
    assert_eq!(comments(&second, ".m.b"), ODD);
    assert_eq!(desk.written(&mut second, "second.adm"), dataset);
    // Writing the dataset has given numbers.
    let numbered = desk.written(&mut first, "numbered.cmd");
    assert_ne!(numbered, commands);
    assert_eq!(desk.written(&mut second, "second.cmd"), numbered);
}

/// Truth: note 7 of the manual's page: all from the end of the statement before through the end of
/// the statement, and for the model all behind the title up to the line that ends them.
const FILE: &str = "Adams View model name: m
!first of the model
!
! second, \"quoted\"
! END OF MODEL COMMENTS
!
!-------------------------------- SYSTEM UNITS ---------------------------------
!
UNITS/
, LENGTH = METER
!
!----------------------------------- PARTS -------------------------------------
! about the ground
!                            adams_view_name='ground'
PART/1
, GROUND
!
! one
!
! two
!
!                              adams_view_name='a'
MARKER/1 ! on the head
, PART = 1 ! on a line
! between lines
, QP = 1, 2, 3 ! at the end
!
!                              adams_view_name='b'
MARKER/2
, PART = 1
!
! behind everything
END
";

#[test]
fn comments_belong_to_the_statement_they_precede_or_stand_in() {
    let desk = Desk::new();
    let mut session = read(&desk.put("m.adm", FILE));
    assert_eq!(comments(&session, ".m"), ["first of the model", "", "second, \"quoted\"", "behind everything"]);
    assert_eq!(comments(&session, ".m.ground"), ["about the ground"]);
    assert_eq!(
        comments(&session, ".m.ground.a"),
        ["one", "", "two", "on the head", "on a line", "between lines", "at the end"]
    );
    assert_eq!(comments(&session, ".m.ground.b"), [""; 0]);
    let text = desk.written(&mut session, "again.adm");
    let mut again = read(&desk.path("again.adm"));
    assert_eq!(comments(&again, ".m.ground.a"), comments(&session, ".m.ground.a"));
    assert_eq!(desk.written(&mut again, "more.adm"), text);
    // And through commands.
    desk.written(&mut session, "m.cmd");
    let mut commands = read(&desk.path("m.cmd"));
    assert_eq!(desk.written(&mut commands, "commands.adm"), text);
}

/// What is switched off stands behind comment marks, as in exports, and is switched off again.
#[test]
fn what_is_switched_off_stays_so() {
    let desk = Desk::new();
    let mut session = commented(&[], &["why it is off"], &[]);
    session.execute("force attributes force_name = .m.b active = off");
    let text = desk.written(&mut session, "off.adm");
    assert!(text.contains("\n!BEAM/1\n!, I = 2\n"), "{text}");
    let mut again = read(&desk.path("off.adm"));
    assert_eq!(comments(&again, ".m.b"), ["why it is off"]);
    assert_eq!(desk.written(&mut again, "again.adm"), text);
}

/// Truth: the line ends the comments of the model. What stands behind it is written there again, and is
/// none of them.
#[test]
fn comments_before_units_keep_their_place() {
    let desk = Desk::new();
    let file = FILE.replace("UNITS/\n", "! why these units\nUNITS/ ! or not\n");
    let mut session = read(&desk.put("m.adm", &file));
    let text = desk.written(&mut session, "again.adm");
    let head: Vec<_> = text.lines().take(9).collect();
    assert_eq!(
        head[1..],
        [
            "! first of the model",
            "! ",
            "! second, \"quoted\"",
            "! behind everything",
            "! END OF MODEL COMMENTS",
            "! why these units",
            "! or not",
            "!",
        ]
    );
    let mut again = read(&desk.path("again.adm"));
    assert_eq!(comments(&again, ".m"), comments(&session, ".m"));
    assert_eq!(desk.written(&mut again, "more.adm"), text);
}

/// A remark that begins like a statement stands where a statement that is switched off would.
#[test]
fn a_remark_behind_a_name_is_a_comment_of_what_follows() {
    let desk = Desk::new();
    let text = "t\nUNITS/SYSTEM=MKS\nPART/1, GROUND\n!  adams_view_name='here'\n!either/or\n!, both\n\
                MARKER/1, PART=1\n!  adams_view_name='gone'\n!and/or\nEND\n";
    let session = read(&desk.put("m.adm", text));
    assert_eq!(comments(&session, ".m.ground.here"), ["either/or", ", both"]);
    assert_eq!(comments(&session, ".m"), ["adams_view_name='gone'", "and/or"]);
}
