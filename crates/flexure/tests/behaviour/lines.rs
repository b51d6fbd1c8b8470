//! Lines, continuation and comments.

use crate::scene::Scene;

// Case 53, documented.
#[test]
fn a_comment_may_stand_behind_the_continuation_mark() {
    let mut s = Scene::beam();
    s.accept("marker create & ! what\n  marker_name = .m.p1.a & ! where\n  location = 1,2,3");
    assert_eq!(s.numbers(".m.p1.a", "location"), [1.0, 2.0, 3.0]);
}

// Case 54, observed.
#[test]
fn a_comment_line_inside_a_command_is_passed_over() {
    for comment in ["   ! label = x &", "   ! label = x"] {
        let mut s = Scene::beam();
        s.accept(&format!("marker create &\n   marker_name = .m.p1.a &\n{comment}\n   location = 1,2,3"));
        assert_eq!(s.numbers(".m.p1.a", "location"), [1.0, 2.0, 3.0]);
    }
}

// Case 55, observed.
#[test]
fn a_comment_of_its_own_continues_nothing() {
    let log = Scene::beam().logged("c.cmd", "! a &\n!  b &\n!  c\n");
    assert_eq!(log, ["! >> ! a &", "! >> !  b &", "! >> !  c"]);
}

// Case 56, observed.
#[test]
fn blanks_may_follow_the_continuation_mark() {
    let mut s = Scene::beam();
    s.accept("marker create marker_name = (eval(\".m.p1.a\")) & \n  location = 1,2,3");
    assert_eq!(s.numbers(".m.p1.a", "location"), [1.0, 2.0, 3.0]);
}

// Case 57, observed; that it always is so is inferred.
#[test]
fn an_empty_line_ends_a_continued_command() {
    let mut s = Scene::beam();
    s.accept("marker create marker_name = .m.p1.a &\n\nmarker create marker_name = .m.p1.b");
    assert!(s.exists(".m.p1.a") && s.exists(".m.p1.b"));
}

// Case 58, observed. The part lies at 0 and marker_1 at x = 2 mm: 6 inches further is 154.4 mm.
#[test]
fn a_value_may_stand_on_the_line_behind_its_parameter() {
    let mut s = Scene::beam();
    s.accept(
        "marker create marker_name = .m.p1.a  &\n   location =   &\n      \
         (LOC_RELATIVE_TO({6inch, 0.0, 0.0}, .m.p1.marker_1))  &\n   relative_to = .m.p1",
    );
    crate::scene::all_close(&s.numbers(".m.p1.a", "location"), &[154.4, 0.0, 0.0], 1e-12);
}

// Case 59, documented and observed.
#[test]
fn a_list_may_be_split_behind_its_commas() {
    let mut s = Scene::beam();
    s.accept("marker create marker_name = .m.p1.a  location = 0.0, &\n 50.0, &\n 100.0");
    assert_eq!(s.numbers(".m.p1.a", "location"), [0.0, 50.0, 100.0]);
}

// Case 60, observed to be accepted.
#[test]
fn the_strings_of_a_function_are_joined() {
    let mut s = Scene::beam();
    s.accept(
        "force create direct single_component_force single_component_force_name = .m.f &\n \
         i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.marker_2 &\n \
         function = \"STEP(TIME,0,0,1,5)\", &\n \" + 3\"",
    );
    assert_eq!(s.text(".m.f", "function"), "STEP(TIME,0,0,1,5) + 3");
}

// Case 61, observed.
#[test]
fn a_comment_may_follow_end() {
    let mut s = Scene::beam();
    s.accept(
        "for variable_name = i start_value = 1 end_value = 2\n  variable set variable_name = n real_value = (eval(i))\n\
         end  ! end for loop\nmarker create marker_name = .m.p1.behind",
    );
    assert_eq!(s.number(".m.n", "real_value"), 2.0);
    assert!(s.exists(".m.p1.behind"));
}

// Case 62, observed.
#[test]
fn an_exclamation_mark_in_parentheses_says_not() {
    let mut s = Scene::beam();
    s.accept(
        "if condition = (! db_exists(\".colors.X\"))\n  marker create marker_name = .m.p1.a\nend\n\
         if condition = (1 != 1)\n  marker create marker_name = .m.p1.b\nend",
    );
    assert!(s.exists(".m.p1.a") && !s.exists(".m.p1.b"));
}

// Case 63, observed.
#[test]
fn a_continuation_mark_in_a_string_is_text() {
    let mut s = Scene::beam();
    let text = "interface dialog execute dialog=$_parent undisp=no &";
    let lines = format!(
        "interface push_button create push_button_name = .gui.main.b commands = \"{text}\"\n\
         marker create marker_name = .m.p1.a comments = \"{text}\"\n"
    );
    let report = s.read("dialog.cmd", &lines);
    assert_eq!((report.failed, report.skipped, report.executed), (0, 1, 1), "{}", s.told(&report));
    assert_eq!(s.value(".m.p1.a", "comments"), flexure::AttributeValue::Texts(vec![text.into()]));
}
