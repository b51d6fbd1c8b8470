//! Keywords and parameters: what is not one is refused with the line and the column of Adams.

use crate::scene::Scene;

const RULE: &str = "! ERROR:  ---------------------------------------------------------------------";

/// The lines between the rules of the only box in a log.
fn boxed(log: &[String]) -> Vec<&str> {
    let rules: Vec<usize> = (0..log.len()).filter(|i| log[*i] == RULE).collect();
    assert_eq!(rules.len(), 2, "{log:#?}");
    log[rules[0] + 1..rules[1]].iter().map(String::as_str).collect()
}

fn not_a_keyword(line: usize, column: usize, word: &str) -> Vec<String> {
    vec![
        format!("! ERROR:  Error detected on line number {line}, character {column} of x.cmd."),
        format!("! ERROR:  '{word}' is not a valid keyword. You may have misspelled"),
        "! ERROR:  the keyword or you may be missing a continuation character(&)".into(),
        "! ERROR:  on the previous line.".into(),
        "! ERROR:  The command was not executed.".into(),
    ]
}

fn not_a_parameter(line: usize, column: usize, word: &str) -> Vec<String> {
    vec![
        format!("! ERROR:  Error detected on line number {line}, character {column} of x.cmd."),
        format!("! ERROR:  '{word}' is not a valid parameter."),
        "! ERROR:  The command was not executed.".into(),
    ]
}

/// The box of a command: its first lines as said, then the lines of the command from the faulty one.
fn check(text: &str, head: &[String], faulty: usize) {
    let log = Scene::beam().logged("x.cmd", text);
    let said = boxed(&log);
    assert_eq!(said[..head.len()], head.iter().map(String::as_str).collect::<Vec<_>>()[..], "{log:#?}");
    let rest: Vec<String> = text
        .lines()
        .enumerate()
        .skip(faulty)
        .map(|(i, line)| format!("! ERROR:  {} {line}", if i == 0 { ">>" } else { "&>" }))
        .collect();
    assert_eq!(said[head.len()..], rest.iter().map(String::as_str).collect::<Vec<_>>()[..]);
}

// Case 64, observed.
#[test]
fn motion_is_no_command() {
    check("motion create motion_name = x\n", &not_a_keyword(1, 8, "motion"), 0);
}

// Case 65, observed.
#[test]
fn a_wrong_parameter_drops_the_whole_command() {
    check(
        "force create body gravitational &\n    field_name = .m.gravity &\n    x_component_gravity = 0.0\n",
        &not_a_parameter(2, 15, "field_name"),
        1,
    );
}

// Case 66, observed.
#[test]
fn where_a_keyword_is_due_a_parameter_is_none() {
    check("simulation single &\n    sim_name = .x\n", &not_a_keyword(2, 13, "sim_name"), 1);
}

// Case 67, observed.
#[test]
fn a_sphere_is_no_shape() {
    check("geometry create shape sphere &\n    sphere_name = .m.p1.s\n", &not_a_keyword(1, 29, "sphere"), 0);
}

// Case 68, observed.
#[test]
fn a_link_takes_no_part_name() {
    let mut s = Scene::beam();
    let said = s.refuse("geometry create shape link &\n link_name = .m.p1.l &\n part_name = .m.p1");
    assert_eq!(said, ["'part_name' is not a valid parameter."]);
}

// Case 70, observed.
#[test]
fn var_set_var_int_sets_an_integer_variable() {
    let mut s = Scene::empty();
    s.accept("var set var=.mdi.tmp_int int=0");
    assert_eq!(s.number(".mdi.tmp_int", "integer_value"), 0.0);
    s.accept("variable set variable_name=.mdi.tmp_int integer_value=7");
    assert_eq!(s.number(".mdi.tmp_int", "integer_value"), 7.0);
}

// Cases 71 and 72, observed.
#[test]
fn words_for_units_are_cut() {
    let mut s = Scene::empty();
    s.accept("defaults units length=mm angle=radians force=newton mass=kg time=minute");
    s.accept("defaults units length=mm force=newton mass=kg time=sec");
    s.accept("defaults units angle = deg");
    let units = s.session.database().units();
    assert_eq!((units.time.name, units.angle.name), ("second", "degrees"));
}

// Case 73, observed.
#[test]
fn undo_begin_and_undo_end_are_blocks() {
    let mut s = Scene::beam();
    s.accept("undo begin\nmarker create marker_name = .m.p1.a\nmarker create marker_name = .m.p1.b\nundo end");
    s.accept("undo backward");
    assert!(!s.exists(".m.p1.a") && !s.exists(".m.p1.b") && s.exists(".m.beam1"));
}

// Case 74, observed.
#[test]
fn def_com_echo_is_a_setting_of_command_files() {
    // Echoing is what the journal always does; the words are understood and nothing is refused.
    let mut s = Scene::empty();
    let report = s.session.execute("def com echo=on");
    assert_eq!(report.failed, 0, "{}", s.told(&report));
    assert_eq!(s.session.execute("defaults command_file echo_commands=on").failed, 0);
}

// Case 69, observed.
#[test]
fn a_bushing_takes_no_rotational_stiffness() {
    let mut s = Scene::beam();
    let said = s.refuse(
        "force create element_like bushing bushing_name = .m.b i_marker_name = .m.p1.marker_1 &\n \
         j_marker_name = .m.ground.marker_2 stiffness = 1,1,1 rotational_stiffness = 1,1,1",
    );
    assert_eq!(said, ["'rotational_stiffness' is not a valid parameter."]);
}
