//! Statements read from text.

use flexure_dataset::{Statements, read_statements};
use text::FileId;

fn split(text: &str) -> Statements {
    read_statements(&elements::registry(), FileId(0), text)
}

const TEXT: &str = "\
a title, whatever/it says
! note one
!                            adams_view_name='bar.1'
PART/02, MASS = 2, CM = 3 ! heavy
!, QG = 9, 9, 9
, IP = 1, 2
, 3
!
REQUEST/7
, COMMENT = tip, load: x
, CNAMES = \"a, b\", \"!\"
, F2 = ATAN2(DX(1,2),
, DY(1,2))
, + 1\\
, F3 = TIME
!
sforce/3, translational, i=1, j=2, actiononly, function = - 2*
, VX(1)
ACCGRAV/
, KGRAV = -9.81
END
BEAM/9 is ignored
";

#[test]
fn statements_have_names_numbers_arguments_and_comments() {
    let found = split(TEXT);
    // What stands behind END and looks like a statement is named.
    let codes: Vec<_> = found.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["dataset/behind-end"]);
    assert_eq!(found.title, "a title, whatever/it says");
    let names: Vec<_> = found.statements.iter().map(|s| (s.name, s.id)).collect();
    assert_eq!(names, [("PART", Some(2)), ("REQUEST", Some(7)), ("SFORCE", Some(3)), ("ACCGRAV", None)]);
    let part = &found.statements[0];
    assert_eq!(part.view_name.as_deref(), Some("bar.1"));
    assert_eq!(part.comments, ["note one", "heavy", ", QG = 9, 9, 9"]);
    assert_eq!(part.value("mass", TEXT).as_deref(), Some("2"));
    assert_eq!(part.value("IP", TEXT).as_deref(), Some("1, 2, 3"));
    assert_eq!(part.value("QG", TEXT), None, "a comment among continued lines does not count");
    let request = &found.statements[1];
    assert_eq!(request.value("COMMENT", TEXT).as_deref(), Some("tip, load: x"));
    assert_eq!(request.value("CNAMES", TEXT).as_deref(), Some("\"a, b\", \"!\""));
    assert_eq!(request.value("F2", TEXT).as_deref(), Some("ATAN2(DX(1,2), DY(1,2)) + 1"));
    assert_eq!(request.value("F3", TEXT).as_deref(), Some("TIME"));
    let force = &found.statements[2];
    assert!(force.has("TRANSLATIONAL") && force.has("ACTIONONLY"));
    assert_eq!(force.value("FUNCTION", TEXT).as_deref(), Some("- 2* VX(1)"));
}

#[test]
fn spans_point_at_the_arguments() {
    let found = split(TEXT);
    let mass = &found.statements[0].arguments[0];
    assert_eq!(&TEXT[mass.span.range()], "MASS = 2");
    assert!(TEXT[found.statements[2].span.range()].starts_with("sforce/3"));
}

#[test]
fn what_is_no_dataset_is_reported_not_dropped() {
    let found = split("t\n, A = 1\nhello world\nPART/1, GROUND\n");
    let codes: Vec<_> = found.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["dataset/stray-continuation", "dataset/not-a-statement", "dataset/missing-end"]);
    assert_eq!(found.statements.len(), 1);
}

/// Every prefix, and bytes without sense, are read without a crash.
#[test]
fn no_text_crashes_the_reader() {
    for end in 0..TEXT.len() {
        let _ = split(&TEXT[..end]);
    }
    let _ = split("\u{0}\n/,=\n,,,\n=\n\"(\n!\u{e4}\n/1\u{20ac}");
}

/// Files whose ending says what they are not.
#[test]
fn datasets_are_told_from_other_texts() {
    for text in ["t\nPART/1", "t\n! note\n\n  units/", "PART/1, GROUND", "! only\nBEAM/3"] {
        assert!(flexure_dataset::looks_like_dataset(text), "{text}");
    }
    for text in ["", "t\n", "t\nin/out", "model create model_name = a\npart/x 7", "t\nu\nPART/1", "! PART/1\nundo"] {
        assert!(!flexure_dataset::looks_like_dataset(text), "{text}");
    }
}
