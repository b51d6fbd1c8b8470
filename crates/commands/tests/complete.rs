//! Completion and help: what may follow half-typed text, read from the tables and the database.

use flexure_commands::{Completion, Interpreter};

fn session() -> Interpreter {
    let mut i = Interpreter::new(elements::registry());
    let report = i.execute(
        "model create model_name = m
defaults units length = inch
part create rigid_body name_and_position part_name = .m.arm
marker create marker_name = .m.arm.tip
marker create marker_name = .m.arm.same
marker create marker_name = .m.ground.same
variable set variable_name = .m.width real_value = 2
macro create macro_name = .mdi.mk user_entered_command = \"make one\" &
  commands_to_be_executed = \"!$at:t=marker\", \"!$how:t=list(fast,slow):d=slow\", \"!$size:t=real:d=1.5\", \"marker modify marker_name=$at\"",
    );
    assert!(!report.has_errors(), "{:?}", report.diagnostics);
    i
}

fn texts(found: &Completion) -> Vec<&str> {
    found.candidates.iter().map(|c| c.text.trim_end()).collect()
}

#[track_caller]
fn offers(text: &str, wanted: &[&str], start: usize) {
    let i = session();
    let found = i.complete(text);
    assert_eq!(texts(&found), wanted, "{text}: {found:?}");
    assert_eq!(found.start, start, "{text}");
}

fn note<'a>(found: &'a Completion, text: &str) -> &'a str {
    let candidate = found.candidates.iter().find(|c| c.text.trim_end() == text);
    &candidate.unwrap_or_else(|| panic!("{text} is not offered: {found:?}")).note
}

#[test]
fn keywords_follow_keywords_cut_short_or_not() {
    offers("mark", &["marker"], 0);
    offers("var cr", &["create"], 4);
    offers("force create element_like be", &["beam"], 26);
    offers("undo &\n ! what now\n for", &["forward"], 20);
    offers("view erase\nundo ba", &["backward"], 16);
    offers("make ", &["one"], 5);
}

#[test]
fn parameters_are_offered_until_they_are_given_or_excluded() {
    let i = session();
    let all = i.complete("force create element_like beam ");
    for name in ["beam_name =", "i_marker_name =", "i_part_name =", "length =", "location ="] {
        assert!(texts(&all).contains(&name), "{name}: {all:?}");
    }
    // An end is given as a marker or as a part.
    let left = i.complete("force create element_like beam beam=b i_m=tip damping_ratio = 0.1 leng = (2 + 3) ");
    for name in ["beam_name =", "i_marker_name =", "damping_ratio =", "length =", "i_part_name ="] {
        assert!(!texts(&left).contains(&name), "{name}: {left:?}");
    }
    assert!(texts(&left).contains(&"j_marker_name ="));
    offers("marker modify marker_name = tip new", &["new_marker_name ="], 32);
}

/// Truth: the units in force, and the defaults of the beam's documentation.
#[test]
fn notes_name_type_unit_default_and_meaning() {
    let i = session();
    let found = i.complete("force create element_like beam ");
    let modulus = note(&found, "youngs_modulus =");
    assert!(modulus.starts_with("real, newton/inch**2, default 1.0: "), "{modulus}");
    assert!(note(&found, "i_marker_name =").starts_with("existing marker: "));
    // Nothing is preset where an object is changed.
    let found = i.complete("force modify element_like beam ");
    let modulus = note(&found, "youngs_modulus =");
    assert!(modulus.starts_with("real, newton/inch**2, unchanged if not given: "), "{modulus}");
    let title = i.complete("defaults units length = ").title;
    assert!(title.starts_with("length: ") && title.contains("inch"), "{title}");
}

#[test]
fn words_are_offered_with_their_default_named() {
    offers("defaults units length = in", &["inch"], 24);
    let i = session();
    let found = i.complete("macro create wrap_in_undo = ");
    assert_eq!(texts(&found), ["yes", "no"]);
    let found = i.complete("force create element_like beam formulation = ");
    assert_eq!(note(&found, "linear"), "default");
}

/// Where an object is changed its present values are offered, never what a new one would get.
#[test]
fn a_change_offers_what_is_there() {
    let mut i = session();
    let report = i.execute(
        "force create element_like beam beam_name=.m.b i_marker_name=.m.arm.tip j_marker_name=.m.ground.same length=3 \
         area=1 ixx=1 iyy=1 izz=1 youngs=2.0E5 shear=8.0E4 formulation=string\nmodel create model_name=other",
    );
    assert!(!report.has_errors(), "{:?}", report.diagnostics);
    let change = "force modify element_like beam beam_name = .m.b";
    let modulus = i.complete(&format!("{change} youngs_modulus = "));
    assert_eq!(texts(&modulus), ["2.0E+05"]);
    assert!(modulus.title.ends_with("(now 2.0E+05)") && !modulus.title.contains("default"), "{modulus:?}");
    let formulation = i.complete(&format!("{change} formulation = "));
    assert_eq!((note(&formulation, "string"), note(&formulation, "linear")), ("as it is", ""));
    assert!(texts(&i.complete("force modify element_like beam beam_name = .m.none youngs_modulus = ")).is_empty());
    assert_eq!(texts(&i.complete("force create element_like beam youngs_modulus = ")), ["1.0"]);
}

#[test]
fn objects_are_offered_short_in_full_and_by_path_the_current_one_first() {
    // `same` is the name of two markers; the one made last is the current one.
    offers("marker delete marker_name = ", &[".m.ground.same", "tip", ".m.arm.same"], 28);
    offers("marker delete marker_name = t", &["tip"], 28);
    offers("marker delete marker_name = .M.a", &[".m.arm.tip", ".m.arm.same"], 28);
    offers("marker delete marker_name = arm.t", &["arm.tip"], 28);
    offers("marker delete marker_name = tip,.m.g", &[".m.ground.same"], 32);
    offers("part delete part_name = ", &["arm", "ground"], 24);
    offers("marker create marker_name = ", &[".m.arm.MARKER_4"], 28);
}

#[test]
fn expressions_offer_functions_and_objects() {
    let i = session();
    let found = i.complete("variable set variable_name = x real_value = (1 + LOC_REL");
    assert_eq!(texts(&found), ["LOC_RELATIVE_TO("]);
    assert!(note(&found, "LOC_RELATIVE_TO(").starts_with("LOC_RELATIVE_TO("));
    assert_eq!(texts(&i.complete("if condition = (2 * wid")), ["width"]);
    assert_eq!(texts(&i.complete("if condition = (DM(.m.arm.ti")), [".m.arm.tip"]);
}

#[test]
fn macros_offer_their_parameters_and_values() {
    let i = session();
    let found = i.complete("make one ");
    assert_eq!(texts(&found), ["at =", "how =", "size ="]);
    assert!(note(&found, "at =").contains("required") && note(&found, "how =").contains("default slow"));
    offers("make one at = t", &["tip"], 14);
    offers("make one how = ", &["fast", "slow"], 15);
    offers("make one size = ", &["1.5"], 16);
}

#[test]
fn files_are_offered_in_quotes() {
    let folder = std::env::temp_dir().join(format!("flexure-complete-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("sub")).unwrap();
    std::fs::write(folder.join("some.cmd"), "").unwrap();
    let i = session();
    let path = folder.display().to_string();
    let open = i.complete(&format!("file command read file_name = \"{path}/s"));
    let bare = i.complete(&format!("file command read file_name = {path}/so"));
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(texts(&open), [format!("{path}/some.cmd\""), format!("{path}/sub/")]);
    assert_eq!(texts(&bare), [format!("\"{path}/some.cmd\"")]);
}

#[test]
fn a_question_mark_asks_unless_it_may_be_part_of_a_value() {
    let i = session();
    for asks in ["", "mar", "marker create ", "marker create marker_name = ", "a x = 1, "] {
        assert!(i.asks_for_help(asks), "{asks}");
    }
    // One object, a word of a list, a number: none of them holds a `?`.
    for asks in [
        "force modify element_like beam beam_name = be",
        "force modify element_like beam formulation = str",
        "force modify element_like beam ixx = 4",
    ] {
        assert!(i.asks_for_help(asks), "{asks}");
    }
    for types in ["marker delete marker_name = ti", "a x = \"really", "a x = (b", "! why"] {
        assert!(!i.asks_for_help(types), "{types}");
    }
}

#[test]
fn questions_and_help_are_answered_in_lines() {
    let i = session();
    let lines = i.question("marker ");
    assert_eq!(lines[0], "behind `marker`");
    assert!(lines.iter().any(|l| l.starts_with("  create ")), "{lines:?}");
    let lines = i.question("");
    assert!(lines.last().unwrap().starts_with("  understood, not executed: "), "{lines:?}");
    assert!(i.help_lines(&["undo", "backw"])[0].starts_with("undo backward: "));
    assert!(i.help_lines(&["marker", "creat"]).iter().any(|l| l.starts_with("  location ")));
    assert!(i.help_lines(&["markr"])[0].contains("did you mean `marker`?"));
    assert!(i.help_lines(&["d"])[0].starts_with("`d` may stand for "));
    assert!(i.help_lines(&[]).iter().any(|l| l.starts_with("  marker ")));
}

/// Half-typed text is normal: every prefix of a program has an answer.
#[test]
fn every_prefix_of_a_program_is_answered() {
    let i = session();
    let text = "for var=i start=1 end=3 ! c\n marker cr mar = (\".m.k\" // i) & ! d\n loc = 1,(2*i),\"x\\\"\n\nend\n.m.x = 3\nmake one at=";
    for (at, _) in text.char_indices() {
        i.complete(&text[..at]);
        i.question(&text[..at]);
    }
}
