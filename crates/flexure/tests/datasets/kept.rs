//! What a dataset says beside its objects: title and headings; and files with odd names.

use super::{Desk, quiet, read};

const PLAIN: &str = "UNITS/SYSTEM=MKS\nPART/1, GROUND\nMARKER/1, PART=1\n";

/// Truth: the first line is the title whatever it says; exports name the model there.
#[test]
fn the_title_line_comes_back() {
    let desk = Desk::new();
    for (title, name, again) in [
        ("a title, with: all sorts", "m", "a title, with: all sorts"),
        ("Adams View model name: car", "car", "Adams View model name: car"),
        ("ADAMS/View model name: old", "old", "Adams View model name: old"),
        ("", "m", "Adams View model name: m"),
    ] {
        let mut session = read(&desk.put("m.adm", &format!("{title}\n{PLAIN}END\n")));
        assert_eq!(session.model_name().as_deref(), Some(name));
        let text = desk.written(&mut session, "again.adm");
        assert_eq!(text.lines().next(), Some(again));
        // And through commands.
        desk.written(&mut session, "again.cmd");
        let mut commands = read(&desk.path("again.cmd"));
        assert_eq!(desk.written(&mut commands, "third.adm"), text);
    }
}

/// A colon or a comma within quotes is part of a heading.
#[test]
fn headings_are_parted_outside_quotes() {
    let desk = Desk::new();
    let text = format!("t\n{PLAIN}REQUEST/1, F2=DZ(1,1)\\TITLE=\"a:b\":\"c, d\":e::\"f g\"\nEND\n");
    let mut session = read(&desk.put("m.adm", &text));
    let titles = |session: &flexure::Session| {
        let request = session.database().find(".m.REQUEST_1", "request").unwrap();
        session.database().value(request, "title").cloned()
    };
    let expected = model::Value::Texts(["a:b", "c, d", "e", "", "f g"].map(str::to_string).to_vec());
    assert_eq!(titles(&session), Some(expected));
    let written = desk.written(&mut session, "m.adm");
    assert!(written.contains("\n, TITLE = \"a:b\":\"c, d\":e::\"f g\"\n"), "{written}");
    assert_eq!(titles(&read(&desk.path("m.adm"))), titles(&session));
}

#[test]
fn a_quote_in_a_heading_is_written_as_an_apostrophe_with_a_warning() {
    let desk = Desk::new();
    let mut session = read(&desk.put("m.adm", &format!("t\n{PLAIN}REQUEST/1, F2=DZ(1,1)\nEND\n")));
    let request = session.resolve("REQUEST_1", "request").unwrap();
    let report =
        session.execute(&format!("output_control modify request request_name = {request} title = \"3\\\" x\""));
    assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
    let path = desk.path("again.adm");
    let warnings = session.write(&path).unwrap();
    assert_eq!(warnings.iter().map(|w| w.code).collect::<Vec<_>>(), ["dataset/quote-not-written"]);
    assert!(std::fs::read_to_string(path).unwrap().contains("\n, TITLE = \"3' x\"\n"));
}

/// The path is text of the command that reads the file, and of the journal.
#[test]
fn files_may_have_odd_names() {
    for name in ["we\"ird.adm", "it's.adm", "tab$1.adm", "a b.adm", "back\\slash.adm", "(1+1).adm"] {
        let desk = Desk::new();
        let path = desk.put(name, &format!("Adams View model name: m\n{PLAIN}END\n"));
        let mut session = quiet();
        session.keep_journal(&desk.path("journal.cmd")).unwrap();
        let report = session.read(&path);
        assert!(!report.has_errors(), "{name}\n{}", session.render(&report.diagnostics, false));
        assert_eq!(session.model_name().as_deref(), Some("m"), "{name}");
        let journal = read(&desk.path("journal.cmd"));
        assert_eq!(journal.model_name().as_deref(), Some("m"), "{name}");
    }
}
