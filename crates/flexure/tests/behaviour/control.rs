//! Loops, conditions, variables, and what happens after an error.

use crate::scene::{Scene, codes};

// Case 99, observed.
#[test]
fn a_loop_passes_cleans_up_and_echoes_its_first_pass() {
    let mut s = Scene::beam();
    let body = "   marker create marker_name = (eval(\".m.p1.a\" // RTOI(i))) location = (eval(i)), 0, 0";
    let opener = "for variable_name = i start_value = 1 end_value = 3";
    let log = s.logged("loop.cmd", &format!("{opener}\n{body}\nend\n"));
    assert!(["a1", "a2", "a3"].iter().all(|n| s.exists(&format!(".m.p1.{n}"))));
    assert!(!s.exists(".m.p1.a4") && !s.exists(".m.i"));
    assert_eq!(log, [format!("! >> {opener}"), format!("! +1>> {body}"), "! +1>> end".to_string()]);
}

// Case 100, observed; that all objects have the last value is inferred.
#[test]
fn a_loop_variable_that_is_referred_to_stays() {
    let mut s = Scene::beam();
    s.accept(
        "marker create marker_name = .m.p1.a\nmarker create marker_name = .m.p1.b\nmarker create marker_name = .m.p1.c",
    );
    let opener = "for variable_name = i start_value = 1 end_value = 3";
    let body = "   marker modify marker_name = (eval(\".m.p1.\" // STR_CHR(RTOI(96 + i)))) location = ((i-1)*50), 0, 0";
    let log = s.logged("loop.cmd", &format!("{opener}\n{body}\nend\n"));
    assert!(s.exists(".m.i"));
    for name in [".m.p1.a", ".m.p1.b", ".m.p1.c"] {
        assert_eq!(s.numbers(name, "location"), [100.0, 0.0, 0.0]);
    }
    let warning = [
        "! WARNING:  The variable .m.i was not deleted because ",
        "! 3 objects depend on it. Using the EVAL function when referencing",
        "! the variable inside this loop eliminate these dependencies.",
        "! .m.p1.a, .m.p1.b, .m.p1.c",
    ];
    assert_eq!(log[3..], warning, "{log:#?}");
}

// Case 101, observed.
#[test]
fn a_loop_over_a_variable_that_exists_is_skipped() {
    let mut s = Scene::beam();
    s.accept("variable create variable_name = ii real_value = 1");
    let text = "if condition = (1)\nfor variable_name=ii start_value=1 end_value=2\n  marker create marker_name=.m.p1.a\nend\nend\n";
    let log = s.logged("loop.cmd", text);
    assert!(!s.exists(".m.p1.a"));
    assert!(log.contains(&"! ERROR:  The Variable 'ii' already exists.".to_string()), "{log:#?}");
    assert!(log.contains(&"! -2>>   marker create marker_name=.m.p1.a".to_string()), "{log:#?}");
}

// Case 102, observed.
#[test]
fn end_takes_no_word_and_the_block_stays_open() {
    let mut s = Scene::beam();
    let text = "for variable_name=i start_value=1 end_value=2\n  marker create marker_name=(eval(\".m.p1.a\" // RTOI(i)))\nend for\n";
    let log = s.logged("loop.cmd", text);
    let expected = [
        "! ERROR:  Error detected on line number 3, character 7 of loop.cmd.",
        "! ERROR:  'for' is not a valid parameter.",
        "! ERROR:  The command was not executed.",
    ];
    assert!(log.windows(3).any(|w| w == expected), "{log:#?}");
    let end = &log[log.len() - 2..];
    assert!(end[0].starts_with("! WARNING:  ") && end[0].ends_with("loop.cmd"), "{log:#?}");
    assert_eq!(end[1], "! WARNING:  The preceding file or macro has an IF, WHILE, or FOR without a matching END.");
}

// Case 103, observed.
#[test]
fn the_other_branch_runs_and_the_first_is_echoed_as_skipped() {
    let mut s = Scene::beam();
    let text = "if condition=0\n marker create marker_name=.m.p1.a\nelse\n marker create marker_name=.m.p1.b\nend\n";
    let log = s.logged("if.cmd", text);
    assert!(!s.exists(".m.p1.a") && s.exists(".m.p1.b"));
    let wanted = [
        "! >> if condition=0",
        "! -1>>  marker create marker_name=.m.p1.a",
        "! -1>> else",
        "! +1>>  marker create marker_name=.m.p1.b",
        "! +1>> end",
    ];
    assert_eq!(log, wanted);
}

/// Markers MAR1, MAR2, ... while `ip` counts up to 5; at one that `reached` says, `word` is obeyed.
fn counted(s: &mut Scene, reached: &str, word: &str) {
    s.accept(&format!(
        "variable create variable_name = ip integer_value = 0\n\
         while condition = (ip < 5)\n\
           variable modify variable_name = ip integer_value = (eval(ip + 1))\n\
           if condition = ({reached})\n    {word}\n  end\n\
           marker create marker_name = (eval(\".m.p1.MAR\" // ip))\n\
         end"
    ));
}

// Case 104, documented.
#[test]
fn break_leaves_a_loop_and_continue_leaves_a_pass() {
    let made = |s: &Scene| -> Vec<i32> { (1..=5).filter(|n| s.exists(&format!(".m.p1.MAR{n}"))).collect() };
    let mut s = Scene::beam();
    s.accept("marker create marker_name = .m.p1.MAR4");
    counted(&mut s, "db_exists(\".m.p1.MAR\" // ip)", "break");
    assert_eq!(made(&s), [1, 2, 3, 4]);
    assert_eq!(s.number(".m.ip", "integer_value"), 4.0);
    let mut s = Scene::beam();
    counted(&mut s, "ip == 3", "continue");
    assert_eq!(made(&s), [1, 2, 4, 5]);
}

// Case 105, inferred.
#[test]
fn a_variable_is_created_once_and_set_often() {
    let mut s = Scene::beam();
    s.accept("variable create variable_name = x real_value = 1");
    assert_eq!(s.unchanged("variable create variable_name = x real_value = 2"), ["The Variable 'x' already exists."]);
    s.accept("variable set variable_name = x real_value = 3");
    assert_eq!(s.number(".m.x", "real_value"), 3.0);
}

const WRONG: &str = "marker create &\n   marker_name = .m.p1.a &\n   locatoin = 1,2,3 &\n   orientation = 0,0,0\n\
                     marker create marker_name = .m.p1.b\n";

// Case 106, observed.
#[test]
fn a_wrong_command_is_dropped_with_its_lines() {
    let mut s = Scene::beam();
    let report = s.read("wrong.cmd", WRONG);
    assert!(!s.exists(".m.p1.a") && s.exists(".m.p1.b"));
    assert_eq!((report.failed, report.executed, report.aborted), (1, 1, false));
    s.accept("marker delete marker_name = .m.p1.b\ndefaults command_file on_error = ignore_command");
    s.read("wrong.cmd", WRONG);
    assert!(!s.exists(".m.p1.a") && s.exists(".m.p1.b"));
}

// Case 107, documented.
#[test]
fn a_file_may_be_left_at_its_first_error() {
    let mut s = Scene::beam();
    s.accept("defaults command_file on_error = abort_file");
    let report = s.read("wrong.cmd", WRONG);
    assert!(report.aborted && !s.exists(".m.p1.b"));
}

// The third mode: what Adams does is unknown; here the faulty parameter counts as not given.
#[test]
fn a_command_may_go_on_without_what_is_wrong_in_it() {
    let mut s = Scene::beam();
    s.accept("defaults command_file on_error = continue_command");
    let report = s.read("wrong.cmd", WRONG);
    assert!(s.exists(".m.p1.a") && s.exists(".m.p1.b"));
    assert_eq!(report.failed, 1);
}

// Case 108, observed.
#[test]
fn a_point_mass_takes_no_fixed_joint() {
    let mut s = Scene::beam();
    s.accept(
        "part create point_mass name_and_position point_mass_name = .m.mass_1 location = 2,0,0\n\
         marker create marker_name = .m.mass_1.cm",
    );
    let joint =
        "constraint create joint fixed joint_name = .m.f i_marker_name = .m.mass_1.cm j_marker_name = .m.p1.marker_1";
    let log = s.logged("joint.cmd", &format!("{joint}\n"));
    assert!(!s.exists(".m.f"));
    let wanted = [
        &format!("! >> {joint}"),
        "! ERROR:  A point mass, such as .m.mass_1, can be constrained with only a",
        "! spherical joint, an atpoint joint primitive, an inline joint primitive,",
        "! or an inplane joint primitive. Do not connect a fixed joint ",
        "! to a point mass.",
    ];
    assert_eq!(log, wanted);
    // What is allowed is not refused.
    s.accept("constraint create joint spherical joint_name = .m.s i_marker_name = .m.mass_1.cm j_marker_name = .m.p1.marker_1");
}

// Case 109, observed.
#[test]
fn mass_without_a_centre_is_a_warning() {
    let mut s = Scene::beam();
    let command = "part modify rigid_body mass_properties part_name=.m.p1 mass=1 ixx=1 iyy=1 izz=1";
    let log = s.logged("mass.cmd", &format!("{command}\n"));
    let warning = "! WARNING:  Part .m.p1 has mass but no center-of-mass marker is specified.";
    assert_eq!(log, [format!("! >> {command}"), warning.to_string()]);
    assert_eq!(s.number(".m.p1", "mass"), 1.0);
    assert_eq!(s.number(".m.p1", "ixx"), 1.0);
}

/// A door whose hinge has its ends half a metre apart.
const CRANE: &str = "model create model_name=crane
part create rigid_body name_and_position part_name=.crane.tower location=0,0,0
marker create marker_name=.crane.tower.cm location=0,0,0
marker create marker_name=.crane.tower.low location=0,0,-500
marker create marker_name=.crane.ground.base location=0,0,0
part modify rigid_body mass_properties part_name=.crane.tower mass=20 center_of_mass_marker=.crane.tower.cm &
   ixx=1.0E+06 iyy=1.0E+06 izz=1.0E+06
constraint create joint revolute joint_name=.crane.jnt_tower_ground i_marker_name=.crane.tower.low &
   j_marker_name=.crane.ground.base
";

// Case 110, observed.
#[test]
fn markers_that_are_apart_are_said_to_be_and_the_run_goes_on() {
    let mut s = Scene::empty();
    s.accept(CRANE);
    let command = "simulation single_run transient type=dynamic initial_static=no end_time=0.01 number_of_steps=1";
    let log = s.logged("run.cmd", &format!("{command}\n"));
    let wanted = [
        &format!("! >> {command}"),
        "! WARNING:  The markers for crane.jnt_tower_ground are not initially coincident.",
        "! The relative displacement between the markers, expressed in the",
        "! J marker coordinate frame is:",
        "! Delta X =   0.0000   Delta Y =   0.0000  Delta Z = -500.0000.",
    ];
    assert_eq!(log[..5], wanted, "{log:#?}");
    assert_eq!(s.session.take_runs().len(), 1);
}

// The warning about inertias at the start of a run, observed.
#[test]
fn inertias_of_very_different_size_are_a_warning_of_the_run() {
    let mut s = Scene::empty();
    s.accept(CRANE);
    s.accept("part modify rigid_body mass_properties part_name=.crane.tower ixx=1.0E+06 iyy=1.0E+06 izz=10");
    let command = "simulation single_run transient type=dynamic initial_static=no end_time=0.01 number_of_steps=1";
    let log = s.logged("run.cmd", &format!("{command}\n"));
    let wanted = [
        "! WARNING:  IP data specified for PART crane.tower ",
        "! may not be physically meaningful, since two Inertias differ by more ",
    ];
    assert!(log.windows(2).any(|w| w == wanted), "{log:#?}");
}

// Case 112, observed with a setting of the product; here a value of the model.
#[test]
fn a_value_is_assigned_by_its_path() {
    let mut s = Scene::beam();
    s.accept(".m.beam1.ixx = 7");
    assert_eq!(s.number(".m.beam1", "ixx"), 7.0);
    s.accept(".m.p1.marker_1.location = 1, 2, 3");
    assert_eq!(s.numbers(".m.p1.marker_1", "location"), [1.0, 2.0, 3.0]);
    // Settings of the interface do not exist here: the assignment is understood, named, and skipped.
    let report = s.session.execute(".sim_preferences.alert=0");
    assert_eq!((report.failed, report.skipped), (0, 1), "{}", s.told(&report));
}

// A cycle is refused by name, and nothing changes.
#[test]
fn values_that_need_each_other_are_refused_by_name() {
    let mut s = Scene::beam();
    s.accept(
        "variable create variable_name = a real_value = 1\nvariable create variable_name = b real_value = (a + 1)",
    );
    let report = s.session.execute("variable modify variable_name = a real_value = (b + 1)");
    assert_eq!(report.failed, 1);
    let text = s.told(&report);
    assert!(text.contains(".m.a") && text.contains(".m.b"), "{text}");
    assert_eq!(s.number(".m.a", "real_value"), 1.0);
}

// A loop without end is stopped where the session says, with its place.
#[test]
fn a_loop_without_end_is_stopped() {
    let mut s = Scene::beam();
    s.session.limit_passes(1000);
    s.accept("variable create variable_name = n integer_value = 0");
    let text = "while condition = (1)\n  variable modify variable_name = n integer_value = (eval(n + 1))\nend\n\
                marker create marker_name = .m.p1.behind\n";
    let report = s.read("endless.cmd", text);
    assert_eq!(codes(&report), ["command/endless-loop"]);
    assert_eq!(s.number(".m.n", "integer_value"), 1000.0);
    assert!(s.told(&report).contains("endless.cmd:1"), "{}", s.told(&report));
    // A loop that would have more passes is refused before its first.
    let report = s.session.execute("for variable_name = i start_value = 1 end_value = 1001\nend");
    assert_eq!(codes(&report), ["command/endless-loop"]);
}

// Where an error came about is said with every call that led there.
#[test]
fn an_error_in_a_macro_in_a_file_shows_all_three_places() {
    let mut s = Scene::beam();
    s.accept(
        "macro create macro_name = inner user_entered_command = \"inner one\" &\n\
           commands_to_be_executed = \"! first\", \"marker create marker_name = .m.nothing.a\"\n\
         macro create macro_name = outer user_entered_command = \"outer one\" commands_to_be_executed = \"inner one\"",
    );
    let inner = s.folder.path().join("inner.cmd");
    std::fs::write(&inner, "! line 1\nouter one\n").unwrap();
    let report = s.read("top.cmd", &format!("! 1\n! 2\nfile command read file_name = \"{}\"\n", inner.display()));
    let error = report.diagnostics.iter().find(|d| d.is_error()).unwrap();
    let place = |span: flexure::text::Span| {
        let at = s.session.sources().line_column(span.file, span.start);
        let name = s.session.sources().name(span.file);
        format!("{}:{}", name.rsplit('/').next().unwrap(), at.line)
    };
    let places: Vec<String> =
        error.primary.iter().map(|l| place(l.span)).chain(error.secondary.iter().map(|l| place(l.span))).collect();
    assert_eq!(places, ["macro .m.inner:2", "macro .m.outer:1", "inner.cmd:2", "top.cmd:3"]);
}

// Case 111, observed.
#[test]
fn a_force_that_is_given_a_part_makes_its_floating_marker() {
    let mut s = Scene::beam();
    let command = "force create direct general_force general_force_name = .m.g i_marker_name = .m.p1.marker_1 &\n\
                      j_part_name = .m.ground ref_marker_name = .m.ground.marker_2 x_force_function = \"1\" &\n\
                      y_force_function = \"0\" z_force_function = \"0\" x_torque_function = \"0\" &\n\
                      y_torque_function = \"0\" z_torque_function = \"0\"\n";
    let log = s.logged("force.cmd", command);
    assert!(s.exists(".m.g"), "{log:#?}");
    let said = "! The floating marker FMARKER_1 has been created on part .m.ground.";
    assert!(log.contains(&said.to_string()), "{log:#?}");
    assert!(s.exists(".m.ground.FMARKER_1"));
}
