//! Names: where new objects go, how old ones are found, what generated ones look like.

use crate::scene::Scene;

// Case 75, observed; that the partial path is the reason is inferred.
#[test]
fn a_new_name_is_bare_or_full() {
    let mut s = Scene::beam();
    let said = s.unchanged("marker create marker_name=ground.GROUND_REF location=0,0,0");
    assert_eq!(said, ["Invalid input. Enter return or a parameter."]);
}

// Case 76, observed.
#[test]
fn a_partial_path_that_means_nothing_is_quoted() {
    let said = Scene::beam()
        .unchanged("constraint create joint fixed joint_name=f i_marker_name=mass_1.cm j_marker_name=marker_2");
    assert_eq!(said, ["No Marker named 'mass_1.cm' was found."]);
}

// Case 77, observed.
#[test]
fn a_full_path_says_which_step_is_missing() {
    let mut s = Scene::beam();
    let command =
        |i: &str| format!("constraint create joint fixed joint_name=f i_marker_name={i} j_marker_name=marker_2");
    let said = s.unchanged(&command(".m.p1.mkr_payload_hang"));
    assert_eq!(said, ["No Marker was found because 'mkr_payload_hang' does not exist beneath '.m.p1'."]);
    let said = s.unchanged(&command(".m.p9.mkr_payload_hang"));
    assert_eq!(said, ["No Marker was found because 'p9' does not exist beneath '.m'."]);
}

// Case 78, documented: the number counts the markers of the model; two were made by name.
#[test]
fn a_marker_without_a_name_goes_below_the_current_part() {
    let mut s = Scene::beam();
    s.accept("marker create location=0,0,0");
    assert!(s.exists(".m.p1.MARKER_3"), "{:?}", s.session.objects("marker"));
}

// Case 79, documented.
#[test]
fn the_prefix_of_markers_can_be_chosen() {
    let mut s = Scene::beam();
    s.accept("defaults name_generation marker marker_prefix = my_mar");
    s.accept("marker create location=0,0,0\nmarker create location=0,0,0");
    assert!(s.exists(".m.p1.MY_MAR_3") && s.exists(".m.p1.MY_MAR_4"), "{:?}", s.session.objects("marker"));
}

// Case 80, documented.
#[test]
fn a_generated_name_in_use_gets_a_further_number() {
    let mut s = Scene::beam();
    // The third and the fourth marker are named as the fifth would be.
    s.accept("marker create marker_name = .m.p1.MARKER_5\nmarker create marker_name = .m.p1.MARKER_5_2");
    s.accept("marker create location=0,0,0");
    assert!(s.exists(".m.p1.MARKER_5_3"), "{:?}", s.session.objects("marker"));
}

// Case 81, observed with fields of the interface; markers here.
#[test]
fn what_a_pattern_means_is_said_before_the_command() {
    let mut s = Scene::beam();
    s.accept("marker create marker_name = .m.p1.a\nmarker create marker_name = .m.p1.b");
    let command = "marker attributes marker_name = .m.p1.* visibility = off";
    let log = s.logged("all.cmd", &format!("{command}\n"));
    let wanted = "! Found 3 Marker entities matching \"*\": .m.p1.marker_1, .m.p1.a, .m.p1.b";
    assert_eq!(log, [wanted.to_string(), format!("! >> {command}")]);
    for name in ["marker_1", "a", "b"] {
        let shown = s.value(&format!(".m.p1.{name}"), "visibility");
        assert_eq!(shown, flexure::AttributeValue::Text("off".into()), "{name}");
    }
}

// Case 82, observed.
#[test]
fn a_text_that_names_an_object_stays_an_expression() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam beam_name = .m.beam1 i_marker_name = (\"p1\" // \".marker_1\")");
    assert_eq!(s.text(".m.beam1", "i_marker_name"), ".m.p1.marker_1");
    assert!(s.export().contains("i_marker_name = (\"p1\" // \".marker_1\")"), "{}", s.export());
}

// Case 83, documented.
#[test]
fn a_bare_name_goes_below_the_current_model() {
    let mut s = Scene::beam();
    s.accept("part create rigid_body name_and_position part_name = hub");
    assert!(s.exists(".m.hub"));
    s.accept("part create rigid_body name_and_position part_name = m");
    assert!(s.exists(".m.m"));
}
