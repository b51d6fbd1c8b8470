//! Beams: which commands are taken, and which are refused.

use crate::scene::{Scene, codes};

const MARKERS: &str = "i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.marker_2";

// Case 1, documented.
#[test]
fn a_beam_is_renamed_and_gets_every_value() {
    let mut s = Scene::beam();
    s.accept(
        "force modify element_like beam beam_name = beam1 new_beam_name = beam2 adams_id = 1 ixx = 4 iyy = 2 izz = 3 \
         y_shear_area_ratio = 0.9 z_shear_area_ratio = 0.8 youngs_modulus = 0.4 shear_modulus = 0.2 length = 2 \
         area_of_cross_section = 1.5 damping_ratio = 2 i_marker_name = marker_1 j_marker_name = marker_2",
    );
    assert!(!s.exists(".m.beam1"));
    for (name, value) in [
        ("adams_id", 1.0),
        ("ixx", 4.0),
        ("iyy", 2.0),
        ("izz", 3.0),
        ("y_shear_area_ratio", 0.9),
        ("z_shear_area_ratio", 0.8),
        ("youngs_modulus", 0.4),
        ("shear_modulus", 0.2),
        ("length", 2.0),
        ("area_of_cross_section", 1.5),
        ("damping_ratio", 2.0),
    ] {
        assert_eq!(s.number(".m.beam2", name), value, "{name}");
    }
    assert_eq!(s.text(".m.beam2", "i_marker_name"), ".m.p1.marker_1");
    assert_eq!(s.text(".m.beam2", "j_marker_name"), ".m.ground.marker_2");
}

// Case 2, documented.
#[test]
fn a_value_may_touch_the_continuation_mark() {
    let mut s = Scene::beam();
    s.accept(
        "force modify element_like beam &\n   beam_name = beam1 &\n   new_beam_name = beam2 &\n   \
         youngs_modulus = 0.4&\n   shear_modulus = 0.2&\n   length = 2",
    );
    assert_eq!(s.number(".m.beam2", "youngs_modulus"), 0.4);
    assert_eq!(s.number(".m.beam2", "shear_modulus"), 0.2);
}

// Case 3, documented for words; for names inferred.
#[test]
fn capitals_and_small_letters_are_the_same() {
    let mut s = Scene::beam();
    s.accept("Force MODIFY Element_Like Beam Beam_Name = BEAM1 Adams_id = 7 Iyy = 2");
    assert_eq!(s.number(".m.beam1", "adams_id"), 7.0);
    assert_eq!(s.number(".m.beam1", "iyy"), 2.0);
}

// Case 4, documented.
#[test]
fn the_beam_created_last_is_meant_without_a_name() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam length = 3");
    assert_eq!(s.number(".m.beam1", "length"), 3.0);
}

// Case 5, inferred.
#[test]
fn the_beam_modified_last_is_meant_without_a_name() {
    let mut s = Scene::beam();
    s.accept(&format!("force create element_like beam beam_name = .m.beam2 {MARKERS}"));
    s.accept("force modify element_like beam beam_name = .m.beam1 ixx = 5");
    s.accept("force modify element_like beam iyy = 6");
    assert_eq!(s.number(".m.beam1", "iyy"), 6.0);
    assert_eq!(s.number(".m.beam2", "iyy"), 1.0);
}

// Case 6, documented; the text is inferred.
#[test]
fn a_beam_cannot_take_the_name_of_another() {
    let mut s = Scene::beam();
    s.accept(&format!("force create element_like beam beam_name = .m.beam2 {MARKERS}"));
    let said = s.unchanged("force modify element_like beam beam_name = .m.beam1 new_beam_name = .m.beam2");
    assert_eq!(said, ["The Beam '.m.beam2' already exists."]);
}

// Case 7, inferred.
#[test]
fn a_bare_name_that_means_no_beam_is_quoted() {
    let said = Scene::beam().unchanged("force modify element_like beam beam_name = nobeam ixx = 1");
    assert_eq!(said, ["No Beam named 'nobeam' was found."]);
}

// Case 8, inferred.
#[test]
fn a_full_name_that_means_no_beam_is_taken_apart() {
    let said = Scene::beam().unchanged("force modify element_like beam beam_name = .m.nobeam ixx = 1");
    assert_eq!(said, ["No Beam was found because 'nobeam' does not exist beneath '.m'."]);
}

// Cases 9 and 10, documented; the text is observed with other commands.
#[test]
fn modify_takes_no_place_and_no_parts() {
    for (name, value) in [("location", "0,0,0"), ("i_part_name", ".m.p1")] {
        let mut s = Scene::beam();
        let text = format!("force modify element_like beam beam_name = .m.beam1 {name} = {value}\n");
        assert_eq!(s.unchanged(&text), [format!("'{name}' is not a valid parameter.")]);
        let log = s.logged("wrong.cmd", &text);
        assert!(log.contains(&"! ERROR:  The command was not executed.".to_string()), "{log:?}");
    }
}

// Case 11, documented.
#[test]
fn words_are_cut_to_what_is_unique() {
    let mut s = Scene::beam();
    s.accept("forc mod el beam b = .m.beam1 l = 5");
    assert_eq!(s.number(".m.beam1", "length"), 5.0);
}

// Case 12, documented; the text is unknown, ours says what it is.
#[test]
fn l_is_length_or_location_while_a_beam_is_created() {
    let mut s = Scene::beam();
    let command = |l: &str| {
        format!("force create element_like beam b = .m.b9 {l} = 5 i_m = .m.p1.marker_1 j_m = .m.ground.marker_2")
    };
    assert_eq!(s.unchanged(&command("l")), ["'l' is an ambiguous parameter."]);
    s.accept(&command("le"));
    assert_eq!(s.number(".m.b9", "length"), 5.0);
}

// Case 13, documented; the text is unknown.
#[test]
fn i_may_be_four_parameters() {
    let mut s = Scene::beam();
    assert_eq!(s.unchanged("force modify element_like beam i = 3"), ["'i' is an ambiguous parameter."]);
    let report = s.session.execute("force modify element_like beam i = 3");
    for name in ["ixx", "iyy", "izz", "i_marker_name"] {
        assert!(report.diagnostics[0].message.contains(name), "{}", report.diagnostics[0].message);
    }
}

// Cases 14 and 15, documented; the numbers in the names are inferred.
#[test]
fn a_beam_without_a_name_gets_one_and_the_defaults() {
    let mut s = Scene::beam();
    s.accept("force delete force_name = .m.beam1");
    s.accept(&format!("force create element_like beam {MARKERS}"));
    for name in ["ixx", "iyy", "izz", "youngs_modulus", "shear_modulus", "length", "area_of_cross_section"] {
        assert_eq!(s.number(".m.BEAM_1", name), 1.0, "{name}");
    }
    for name in ["y_shear_area_ratio", "z_shear_area_ratio", "damping_ratio"] {
        assert_eq!(s.number(".m.BEAM_1", name), 0.0, "{name}");
    }
    assert_eq!(s.id(".m.BEAM_1"), 0);
    assert_eq!(s.text(".m.BEAM_1", "formulation"), "linear");
    s.accept(&format!("force create element_like beam {MARKERS}"));
    assert!(s.exists(".m.BEAM_2"));
    assert_eq!(s.session.objects("beam"), [".m.BEAM_1", ".m.BEAM_2"]);
}

// Case 16, documented.
#[test]
fn parts_and_a_place_get_a_marker_each() {
    let mut s = Scene::beam();
    // The part is moved, so that its own frame and the global one differ.
    s.accept("part modify rigid_body name_and_position part_name = .m.p1 location = 0,5,0");
    s.accept(
        "force create element_like beam beam_name = .m.b2 i_part_name = .m.p1 j_part_name = .m.ground location = 1,0,0",
    );
    let (i, j) = (s.text(".m.b2", "i_marker_name"), s.text(".m.b2", "j_marker_name"));
    assert!(i.starts_with(".m.p1.") && j.starts_with(".m.ground."), "{i} {j}");
    let database = s.session.database();
    for name in [&i, &j] {
        let pose = database.global_pose(database.find(name, "marker").unwrap());
        assert!(pose.origin.abs_diff_eq(glam::DVec3::X, 1e-12), "{name} is at {}", pose.origin);
    }
    assert_eq!(s.numbers(&j, "orientation"), [0.0, 0.0, 0.0]);
}

// Case 17, documented; the text is unknown.
#[test]
fn a_marker_and_a_part_for_the_same_end_exclude_each_other() {
    let text = format!("force create element_like beam beam_name = .m.b2 {MARKERS} i_part_name = .m.p1");
    let mut s = Scene::beam();
    s.unchanged(&text);
    let report = s.session.execute(&text);
    assert_eq!(codes(&report), ["command/conflicting-arguments"]);
    assert!(!s.exists(".m.b2"));
}

// Case 18, observed with a single-component force.
#[test]
fn what_is_missing_in_a_file_is_asked_of_its_next_line() {
    let mut s = Scene::beam();
    let command = "force create element_like beam beam_name = .m.b2 i_marker_name = .m.p1.marker_1";
    let log = s.logged("beam.cmd", &format!("{command}\n\nmarker create marker_name = .m.p1.after\n"));
    assert!(!s.exists(".m.b2") && s.exists(".m.p1.after"));
    let rule = "! ERROR:  ---------------------------------------------------------------------";
    let wanted = [
        &format!("! >> {command}"),
        "! Enter j_marker_name (required)",
        rule,
        "! ERROR:  Error detected on line number 2, character 0 of beam.cmd.",
        "! ERROR:  Invalid input. Enter '.' or an entity name.",
        "! ERROR:  The command was not executed.",
        "! ERROR:  -> ",
        rule,
        "! >> marker create marker_name = .m.p1.after",
    ];
    assert_eq!(log, wanted);
    // An answer that fits is taken.
    let log =
        s.logged("again.cmd", &format!("{command}\n.m.ground.marker_2\nmarker create marker_name = .m.p1.last\n"));
    assert_eq!(s.text(".m.b2", "j_marker_name"), ".m.ground.marker_2");
    assert!(s.exists(".m.p1.last"));
    assert_eq!(log[1..3], ["! Enter j_marker_name (required)", "! -> .m.ground.marker_2"]);
}

// Case 20, documented; the text is unknown, ours names the number.
#[test]
fn a_damping_matrix_has_21_terms() {
    let mut s = Scene::beam();
    for count in [20, 22] {
        let terms: Vec<String> = (1..=count).map(|n| n.to_string()).collect();
        let said = s.unchanged(&format!(
            "force modify element_like beam beam_name = .m.beam1 matrix_of_damping_terms = {}",
            terms.join(",")
        ));
        assert_eq!(said, ["21 values are required for 'matrix_of_damping_terms'."]);
    }
}

// Case 21, inferred.
#[test]
fn the_placeholder_of_the_help_page_is_no_matrix() {
    Scene::beam()
        .unchanged("force modify element_like beam beam_name = .m.beam1 matrix_of_damping_terms = any 6x6 table");
}

// Case 22, documented.
#[test]
fn the_law_is_one_of_three_words() {
    let mut s = Scene::beam();
    let set = |word: &str| format!("force modify element_like beam beam_name=.m.beam1 formulation = {word}");
    for (typed, stored) in [("STRING", "string"), ("nonlinear", "nonlinear"), ("str", "string"), ("n", "nonlinear")] {
        s.accept(&set(typed));
        assert_eq!(s.text(".m.beam1", "formulation"), stored);
    }
    s.unchanged(&set("cubic"));
}

// Case 36, documented; that the markers stay is inferred.
#[test]
fn a_deleted_beam_leaves_its_markers() {
    let mut s = Scene::beam();
    s.accept("force delete force_name = .m.beam1");
    assert!(!s.exists(".m.beam1") && s.exists(".m.p1.marker_1") && s.exists(".m.ground.marker_2"));
}

// Case 37, documented; the wording is inferred.
#[test]
fn delete_knows_no_kinds_of_force() {
    let said = Scene::beam().unchanged("force delete element_like beam beam_name = .m.beam1");
    assert_eq!(said, ["'element_like' is not a valid parameter."]);
}

// Case 38, observed in an export.
#[test]
fn a_colour_is_set_and_written_behind_the_beam() {
    let mut s = Scene::beam();
    s.accept("force attributes force_name = .m.beam1 color = RED");
    let export = s.export();
    let (create, attributes) = (export.find("force create element_like beam"), export.find("force attributes"));
    assert!(create.unwrap() < attributes.unwrap(), "{export}");
    assert!(export.contains("force attributes  &\n   force_name = .m.beam1  &\n   color = RED\n"), "{export}");
}

// Case 39, documented.
#[test]
fn a_pattern_at_the_root_means_the_forces_of_all_models() {
    let mut s = Scene::beam();
    s.accept(
        "model create model_name = n\nmarker create marker_name = .n.ground.a\npart create rigid_body \
              name_and_position part_name = .n.p\nmarker create marker_name = .n.p.a",
    );
    s.accept("force create element_like beam beam_name = .n.b i_marker_name = .n.p.a j_marker_name = .n.ground.a");
    s.accept("force attributes force_name = .* size_of_icons = 5");
    assert_eq!(s.number(".m.beam1", "size_of_icons"), 5.0);
    assert_eq!(s.number(".n.b", "size_of_icons"), 5.0);
}

// Case 45, documented.
#[test]
fn comments_are_written_before_the_statement() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam beam_name = .m.beam1 comments = \"first\", \"second\"");
    let data_set = s.data_set();
    let at = |text: &str| data_set.find(text).unwrap_or_else(|| panic!("no {text} in\n{data_set}"));
    assert!(at("! first\n") < at("! second\n") && at("! second\n") < at("BEAM/1\n"), "{data_set}");
}

// Case 46, inferred.
#[test]
fn modifying_nothing_is_accepted() {
    let mut s = Scene::beam();
    let before = s.export();
    s.accept("force modify element_like beam beam_name = .m.beam1");
    assert_eq!(s.export(), before);
}

// Case 47, documented.
#[test]
fn an_odd_name_needs_quotes() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam beam_name = .m.beam1 new_beam_name = \"1st beam\"");
    s.accept("force modify element_like beam beam_name = .m.\"1st beam\" ixx = 2");
    s.accept("force modify element_like beam beam_name = \"1st beam\" iyy = 3");
    assert_eq!(s.number(".m.\"1st beam\"", "ixx"), 2.0);
    assert_eq!(s.number(".m.\"1st beam\"", "iyy"), 3.0);
    s.unchanged("force modify element_like beam beam_name = \"1st beam\" new_beam_name = 1st");
}

// Case 48, inferred.
#[test]
fn both_ends_may_be_on_the_same_body_until_a_run() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam beam_name = .m.beam1 i_marker_name = .m.ground.marker_2");
    assert_eq!(s.text(".m.beam1", "i_marker_name"), ".m.ground.marker_2");
}

// Case 49, documented; that the id is 0 is inferred.
#[test]
fn a_copy_has_the_same_values_and_no_id() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam beam_name = .m.beam1 adams_id = 4 ixx = 3");
    s.accept("force copy force_name = .m.beam1 new_force_name = .m.beam1b");
    assert_eq!(s.number(".m.beam1b", "ixx"), 3.0);
    assert_eq!(s.number(".m.beam1b", "length"), 2.0);
    assert_eq!(s.id(".m.beam1b"), 0);
    assert_eq!(s.text(".m.beam1b", "i_marker_name"), ".m.p1.marker_1");
}

// Case 52, documented; the layout is our own.
#[test]
fn a_listing_goes_to_the_window_or_to_a_file() {
    let mut s = Scene::beam();
    s.accept(&format!("force create element_like beam beam_name = .m.other {MARKERS}"));
    s.accept("list_info force beam_name = .m.beam1");
    let brief = s.window();
    let text = brief.join("\n");
    assert!(text.contains(".m.beam1") && !text.contains(".m.other"), "{text}");
    s.accept("list_info force beam_name = .m.beam1 brief = off");
    assert!(s.window().len() > brief.len());
    let file = s.folder.path().join("x");
    s.accept(&format!(
        "list_info force beam_name = .m.beam1 write_to_terminal = off file_name = \"{}\"",
        file.display()
    ));
    assert_eq!(s.window(), Vec::<String>::new());
    assert!(std::fs::read_to_string(file).unwrap().contains(".m.beam1"));
}
