//! The help page of `force modify element_like beam`, clause by clause and in its order: parameters as
//! the table lists them, then the numbered notes, cautions and tips. What belongs to the page's
//! commands and stands on other pages (creation by parts, copy, attributes, listing) is in
//! `help_page_more.rs`, damping terms in `help_page_damping.rs`, the traps in `beam_traps.rs`.
//!
//! Expected values are the page's own, closed forms of its equations, or the sentences Adams prints
//! where they are known.

#[path = "behaviour/scene.rs"]
#[allow(dead_code)]
mod scene;

use flexure::AttributeValue;
use scene::{Scene, close, codes};

fn modify(s: &mut Scene, values: &str) {
    s.accept(&format!("force modify element_like beam beam_name = .m.beam1 {values}"));
}

// ---- Format and example ----

/// Parameters and values of the page's example, in its order and with its capitals; the damping matrix
/// has none there.
const EXAMPLE: [(&str, &str); 15] = [
    ("beam_name", "beam1"),
    ("new_beam_name", "beam2"),
    ("Adams_id", "1"),
    ("ixx", "4"),
    ("iyy", "2"),
    ("izz", "3"),
    ("y_shear_area_ratio", "0.9"),
    ("z_shear_area_ratio", "0.8"),
    (TIGHT, "0.4"),
    ("shear_modulus", "0.2"),
    ("length", "2"),
    ("area_of_cross_section", "1.5"),
    ("damping_ratio", "2"),
    ("i_marker_name", "marker_1"),
    ("j_marker_name", "marker_2"),
];
/// Where the page leaves no blank before `&`.
const TIGHT: &str = "youngs_modulus";

/// A command of such pairs, each value on a line of its own as the page sets them.
fn command(pairs: &[(&str, &str)]) -> String {
    let mut text = "force modify element_like beam".to_string();
    let mut blank = " ";
    for (name, value) in pairs {
        text.extend([blank, "&\n", name, " =\n", value]);
        blank = if *name == TIGHT { "" } else { " " };
    }
    text + "\n"
}

#[test]
fn the_example_is_executed_as_it_is_printed() {
    let mut s = Scene::beam();
    let report = s.accept(&command(&EXAMPLE));
    // The page sets lines that end in `=`, which Adams View would need `&` for: noted once a line.
    assert!(report.diagnostics.iter().any(|d| d.code == "syntax/continued-without-mark"));
    assert!(!s.exists(".m.beam1"));
    let wanted = [
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
    ];
    for (name, value) in wanted {
        assert_eq!(s.number(".m.beam2", name), value, "{name}");
    }
    assert_eq!(s.text(".m.beam2", "i_marker_name"), ".m.p1.marker_1");
    assert_eq!(s.text(".m.beam2", "j_marker_name"), ".m.ground.marker_2");
}

/// Where the page describes the matrix in words there is no value: refused, and nothing is changed.
#[test]
fn the_placeholder_of_the_example_is_refused_with_what_is_wanted() {
    let mut s = Scene::beam();
    let mut pairs = EXAMPLE.to_vec();
    pairs.insert(13, ("matrix_of_damping_terms", "any 6x6 table"));
    let text = command(&pairs);
    s.unchanged(&text);
    let report = s.session.execute(&text);
    let error = report.diagnostics.iter().find(|d| d.is_error()).unwrap();
    assert_eq!(error.message, "`matrix_of_damping_terms` wants 21 or 36 numbers, not 1");
}

/// Capitals as on the page: `Adams_id`, `Iyy`, `Izz`.
#[test]
fn capitals_and_small_letters_may_be_mixed() {
    let mut s = Scene::beam();
    s.accept("FORCE Modify ELEMENT_LIKE beam Beam_Name = BEAM1 Adams_id = 3 Iyy = 2 Izz = 5 FORMULATION = String");
    assert_eq!((s.id(".m.beam1"), s.number(".m.beam1", "iyy"), s.number(".m.beam1", "izz")), (3, 2.0, 5.0));
    assert_eq!(s.text(".m.beam1", "formulation"), "string");
}

#[test]
fn words_may_be_cut_while_they_stay_unique() {
    let mut s = Scene::beam();
    s.accept("forc mod ele beam beam=beam1 ix=4");
    assert_eq!(s.number(".m.beam1", "ixx"), 4.0);
    for (word, name) in [
        ("l", "length"),
        ("ar", "area_of_cross_section"),
        ("y_", "y_shear_area_ratio"),
        ("z", "z_shear_area_ratio"),
        ("yo", "youngs_modulus"),
        ("s", "shear_modulus"),
        ("d", "damping_ratio"),
        ("iy", "iyy"),
        ("iz", "izz"),
        ("ad", "adams_id"),
    ] {
        modify(&mut s, &format!("{word} = 7"));
        assert_eq!(s.number(".m.beam1", name), 7.0, "{word}");
    }
}

/// `for` is a word of its own, so that forces cannot be cut to it; the loop that it would begin does not
/// swallow what follows.
#[test]
fn for_begins_a_loop_and_the_mending_is_offered() {
    let mut s = Scene::beam();
    let report = s.read("short.cmd", "for mod ele beam beam=beam1 ix=4\nforce modify element_like beam iyy = 9\n");
    assert_eq!(codes(&report), ["command/unknown-argument"]);
    let fix = report.diagnostics[0].helps[0].fix.as_ref().unwrap();
    assert_eq!(fix.replacement, "forc");
    assert_eq!(s.number(".m.beam1", "iyy"), 9.0, "the next command is executed");
}

// ---- beam_name, new_beam_name ----

#[test]
fn without_a_name_the_current_beam_is_meant() {
    let mut s = Scene::beam();
    s.accept("force modify element_like beam ixx = 5");
    s.accept("force create element_like beam beam_name = other i_marker_name = marker_1 j_marker_name = marker_2");
    s.accept("force modify element_like beam ixx = 6");
    assert_eq!((s.number(".m.beam1", "ixx"), s.number(".m.other", "ixx")), (5.0, 6.0));
    // A beam that is named becomes the current one.
    modify(&mut s, "iyy = 1");
    s.accept("force modify element_like beam ixx = 7");
    assert_eq!((s.number(".m.beam1", "ixx"), s.number(".m.other", "ixx")), (7.0, 6.0));
}

#[test]
fn a_beam_gets_a_new_name_and_keeps_everything_else() {
    let mut s = Scene::beam();
    s.accept("output_control create request request_name = r f2 = \"BEAM(.m.beam1, 0, 2, 0)\"");
    modify(&mut s, "new_beam_name = beam2");
    assert!(!s.exists(".m.beam1") && s.number(".m.beam2", "length") == 2.0);
    // What refers to it follows.
    assert!(s.export().contains("BEAM(.m.beam2, 0, 2, 0)"), "{}", s.export());
    assert!(s.session.undo() && s.exists(".m.beam1"));
}

/// A caution of the page: full names of beams are unique. The complaint is in Adams' words.
#[test]
fn two_beams_cannot_have_one_name() {
    let mut s = Scene::beam();
    s.accept("force create element_like beam beam_name = beam2 i_marker_name = marker_1 j_marker_name = marker_2");
    for new in ["beam2", ".m.beam2", "BEAM2"] {
        let said = s.unchanged(&format!("force modify element_like beam beam_name = beam1 new_beam_name = {new}"));
        assert_eq!(said, [format!("The Beam '{new}' already exists.")]);
    }
    let create = "force create element_like beam beam_name = beam1 i_marker_name = marker_1 j_marker_name = marker_2";
    assert_eq!(s.unchanged(create), ["The Beam 'beam1' already exists."]);
}

// ---- adams_id (note 6) ----

#[test]
fn an_id_that_is_not_zero_stands_in_the_dataset() {
    let mut s = Scene::beam();
    modify(&mut s, "adams_id = 12");
    assert!(s.data_set().contains("\nBEAM/12\n"));
}

#[test]
fn a_zero_is_replaced_when_a_dataset_is_written_and_kept_for_good() {
    let mut s = Scene::beam();
    modify(&mut s, "adams_id = 0");
    s.accept(
        "force create element_like beam beam_name = b adams_id = 1 i_marker_name = marker_1 j_marker_name = marker_2",
    );
    // 1 is taken, so that the number generated is another one.
    assert!(s.data_set().contains("\nBEAM/2\n"));
    assert_eq!(s.id(".m.beam1"), 2);
    assert!(s.export().contains("beam_name = .m.beam1  &\n   adams_id = 2  &\n"), "{}", s.export());
    s.accept("force delete force_name = b");
    assert!(s.data_set().contains("\nBEAM/2\n"), "kept, although 1 is free now");
}

#[test]
fn an_id_is_unique_whole_and_not_negative() {
    let mut s = Scene::beam();
    modify(&mut s, "adams_id = 5");
    let create = |id: &str| {
        format!("force create element_like beam beam_name = b adams_id = {id} i_m = marker_1 j_m = marker_2")
    };
    for (id, code) in [("5", "name/id-taken"), ("-3", "value/negative-id"), ("1.5", "value/not-integer")] {
        s.unchanged(&create(id));
        assert_eq!(codes(&s.session.execute(&create(id))), [code]);
    }
    // Other classes count for themselves, and a beam keeps its own number.
    s.accept("marker modify marker_name = marker_1 adams_id = 5");
    modify(&mut s, "adams_id = 5");
}

// ---- comments (note 7) ----

#[test]
fn comments_survive_a_command_file() {
    for (typed, wanted) in [
        ("\"one line\"", vec!["one line"]),
        ("\"first\", \"second, with a comma\", \"dr\u{e4}i\"", vec!["first", "second, with a comma", "dr\u{e4}i"]),
        ("\"with \\\"quotes\\\"\"", vec!["with \"quotes\""]),
    ] {
        let mut s = Scene::beam();
        modify(&mut s, &format!("comments = {typed}"));
        let lines = |s: &Scene| match s.value(".m.beam1", "comments") {
            AttributeValue::Texts(all) => all,
            AttributeValue::Text(one) => vec![one],
            other => panic!("{other:?}"),
        };
        assert_eq!(lines(&s), wanted);
        let export = s.export();
        let mut again = Scene::of_export(&export);
        assert_eq!(lines(&again), wanted, "{export}");
        assert_eq!(again.export(), export);
        let data_set = s.data_set();
        let statement = data_set.find("\nBEAM/").unwrap();
        for line in wanted {
            let at = data_set.find(&format!("! {line}")).unwrap_or_else(|| panic!("no {line} in\n{data_set}"));
            assert!(at < statement, "comments go before the statement");
        }
    }
}

// ---- values ----

const NUMBERS: [(&str, &str); 8] = [
    ("ixx", "mm**4"),
    ("iyy", "mm**4"),
    ("izz", "mm**4"),
    ("youngs_modulus", "newton/mm**2"),
    ("shear_modulus", "newton/mm**2"),
    ("length", "mm"),
    ("area_of_cross_section", "mm**2"),
    ("damping_ratio", "second"),
];

#[test]
fn values_have_the_units_of_their_kind() {
    for (name, unit) in NUMBERS {
        let mut s = Scene::beam();
        for text in [format!("{name} = 3({unit})"), format!("{name} = (3({unit}))")] {
            modify(&mut s, &text);
            assert_eq!(s.number(".m.beam1", name), 3.0, "{text}");
        }
        let wrong = format!("force modify element_like beam beam_name = beam1 {name} = 3(kg)");
        s.unchanged(&wrong);
        assert_eq!(codes(&s.session.execute(&wrong)), ["unit/wrong-dimension"], "{name}");
    }
}

/// Truth: 1 inch = 25.4 mm, 1 cm^2 = 100 mm^2, 1 GPa = 1000 N/mm^2, 1 psi = 4.4482216152605 N / (25.4 mm)^2.
#[test]
fn labels_of_other_systems_are_converted() {
    let mut s = Scene::beam();
    modify(
        &mut s,
        "length = 0.5meter area_of_cross_section = 3(cm**2) ixx = 1(inch**4) damping_ratio = 5(millisecond) \
         youngs_modulus = 210(knewton/mm**2) shear_modulus = 1(pound_force/inch**2)",
    );
    for (name, value) in [
        ("length", 500.0),
        ("area_of_cross_section", 300.0),
        ("ixx", 25.4_f64.powi(4)),
        ("damping_ratio", 0.005),
        ("youngs_modulus", 210e3),
        ("shear_modulus", 4.4482216152605 / (25.4 * 25.4)),
    ] {
        close(s.number(".m.beam1", name), value, 1e-14 * value); // a few roundings of factors
    }
}

#[test]
fn expressions_stay_alive_and_eval_does_not() {
    let mut s = Scene::beam();
    modify(&mut s, "length = (DM(marker_1, marker_2)) area_of_cross_section = (eval(DM(marker_1, marker_2)))");
    s.accept("marker modify marker_name = marker_1 location = 3, 4, 0");
    assert_eq!(s.number(".m.beam1", "length"), 5.0);
    assert_eq!(s.number(".m.beam1", "area_of_cross_section"), 2.0);
    s.accept("variable create variable_name = .m.x real_value = 3");
    for (name, _) in NUMBERS {
        modify(&mut s, &format!("{name} = (2 * .m.x)"));
        assert_eq!(s.number(".m.beam1", name), 6.0, "{name}");
    }
    s.accept("variable modify variable_name = .m.x real_value = 10");
    for (name, _) in NUMBERS {
        assert_eq!(s.number(".m.beam1", name), 20.0, "{name}");
    }
}
