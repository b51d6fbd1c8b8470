//! The second half of the help page of `force modify element_like beam`: markers, theory, names, `?`;
//! and what belongs to beams on the pages beside it: creation by markers and by parts, deletion, copies,
//! attributes, listings. The first half is `help_page.rs`.

#[path = "behaviour/scene.rs"]
#[allow(dead_code)]
mod scene;

use glam::{DMat3, DVec3};
use model::Pose;
use scene::{Scene, all_close, codes};

/// What rounding leaves of poses: some ten products and sums of numbers below 10, each rounded by a part in
/// 4.5E15, and angles that were degrees.
const ROUNDING: f64 = 1e-14;

const MARKERS: &str = "i_marker_name = marker_1 j_marker_name = marker_2";

fn modify(s: &mut Scene, values: &str) {
    s.accept(&format!("force modify element_like beam beam_name = .m.beam1 {values}"));
}

fn pose(s: &Scene, marker: &str) -> Pose {
    let database = s.session.database();
    database.global_pose(database.find(marker, "marker").unwrap_or_else(|| panic!("no {marker}")))
}

// ---- i_marker_name, j_marker_name ----

#[test]
fn markers_are_exchanged_by_name() {
    let mut s = Scene::beam();
    modify(&mut s, "i_marker_name = .m.ground.marker_2 j_marker_name = .m.p1.marker_1");
    assert_eq!(s.text(".m.beam1", "i_marker_name"), ".m.ground.marker_2");
    assert_eq!(s.text(".m.beam1", "j_marker_name"), ".m.p1.marker_1");
    let said = s.unchanged("force modify element_like beam beam_name = .m.beam1 i_marker_name = nowhere");
    assert_eq!(said, ["No Marker named 'nowhere' was found."]);
    s.unchanged("force modify element_like beam beam_name = .m.beam1 i_marker_name = .m.p1");
}

// ---- formulation: the row of the page without a name ----

#[test]
fn the_theory_is_linear_by_default_string_or_nonlinear() {
    let mut s = Scene::beam();
    assert_eq!(s.text(".m.beam1", "formulation"), "linear");
    for (typed, stored) in
        [("string", "string"), ("NONLINEAR", "nonlinear"), ("l", "linear"), ("s", "string"), ("non", "nonlinear")]
    {
        modify(&mut s, &format!("formulation = {typed}"));
        assert_eq!(s.text(".m.beam1", "formulation"), stored);
        s.accept(&format!("force create element_like beam beam_name = b {MARKERS} formulation = {typed}"));
        assert_eq!(s.text(".m.b", "formulation"), stored);
        s.accept("force delete force_name = b");
        assert!(s.export().contains(&format!("formulation = {stored}\n")), "{}", s.export());
        assert!(s.data_set().contains(&format!(", FORMULATION = {}\n", stored.to_uppercase())), "{}", s.data_set());
    }
    let wrong = "force modify element_like beam beam_name = .m.beam1 formulation = cubic";
    s.unchanged(wrong);
    let report = s.session.execute(wrong);
    assert_eq!(codes(&report), ["command/unknown-word"]);
    assert!(s.told(&report).contains("linear, string, nonlinear"), "{}", s.told(&report));
}

// ---- notes 4 and 5: names ----

#[test]
fn odd_names_are_quoted_wherever_they_stand() {
    for name in ["1st beam", "a/b", "with blank", "tr\u{e4}ger \u{3b1}", "50%", "&!", "a=b, c"] {
        let mut s = Scene::beam();
        modify(&mut s, &format!("new_beam_name = \"{name}\""));
        let quoted = format!(".m.\"{name}\"");
        for (reference, value) in
            [(quoted.clone(), 2.0), (format!("\"{name}\""), 3.0), (format!(".\"m\".\"{name}\""), 4.0)]
        {
            s.accept(&format!("force modify element_like beam beam_name = {reference} ixx = {value}"));
            assert_eq!(s.number(&quoted, "ixx"), value, "{reference}");
        }
        let export = s.export();
        let mut again = Scene::of_export(&export);
        assert_eq!(again.number(&quoted, "ixx"), 4.0, "{export}");
        assert_eq!(again.export(), export);
        assert!(s.data_set().contains("BEAM/1"), "{name}");
    }
    let mut s = Scene::beam();
    s.unchanged("force modify element_like beam beam_name = beam1 new_beam_name = 1st beam");
}

/// A full name overrides the default parent, which must be there already.
#[test]
fn a_full_name_says_what_the_beam_belongs_to() {
    let mut s = Scene::beam();
    s.accept("model create model_name = other");
    s.accept("force create element_like beam beam_name = .m.b i_m = .m.p1.marker_1 j_m = .m.ground.marker_2");
    assert!(s.exists(".m.b"), "not in the current model");
    for (parent, sentence) in [(".nowhere", "nothing is named `.nowhere`"), (".m.p1", "a beam cannot be below `.m.p1`")]
    {
        let command = format!("force modify element_like beam beam_name = .m.b new_beam_name = {parent}.b");
        s.unchanged(&command);
        let report = s.session.execute(&command);
        assert_eq!(codes(&report), ["name/no-parent"]);
        assert!(report.diagnostics[0].message.contains(sentence), "{}", report.diagnostics[0].message);
    }
}

#[test]
fn a_name_is_generated_where_none_is_given() {
    let mut s = Scene::beam();
    s.accept(&format!("force create element_like beam {MARKERS}"));
    s.accept(&format!("force create element_like beam {MARKERS}"));
    assert_eq!(s.session.objects("beam"), [".m.beam1", ".m.BEAM_2", ".m.BEAM_3"]);
}

// ---- tips: `?` ----

#[test]
fn a_question_mark_lists_what_may_stand_there() {
    let s = Scene::beam();
    let ask = |text: &str| s.session.question(text).join("\n");
    for (text, wanted) in [
        ("", "force"),
        ("force ", "modify"),
        ("force modify ", "element_like"),
        ("force modify element_like ", "beam"),
        ("force modify element_like beam ", "matrix_of_damping_terms"),
        ("force modify element_like beam beam_name=", "beam1  Beam, the current one"),
        ("force modify element_like beam new_beam_name=", ".m.BEAM_2  the next free name"),
        ("force modify element_like beam formulation=", "nonlinear"),
        ("force modify element_like beam i_marker_name=", "marker_1"),
        ("force modify element_like beam length=", "length: real, mm"),
        ("force modify element_like beam comments=", "text, one or more"),
        ("force modify element_like beam matrix_of_damping_terms=", "all 36 if it is symmetric"),
        ("force modify element_like beam beam_name=beam1 ixx=4 ", "iyy"),
        ("force create element_like beam i_part_name=", "p1"),
        ("force delete force_name=", "beam1"),
    ] {
        assert!(ask(text).contains(wanted), "{text}?\n{}", ask(text));
    }
    assert!(
        !ask("force modify element_like beam beam_name=").contains("gravity"),
        "the tip's words are of another page"
    );
}

// ---- force create element_like beam ----

#[test]
fn creation_takes_every_parameter() {
    let mut s = Scene::beam();
    let terms: Vec<String> = (1..=21).map(|k| k.to_string()).collect();
    s.accept(&format!(
        "force create element_like beam beam_name = .m.b adams_id = 8 comments = \"c\" ixx = 1 iyy = 2 izz = 3 \
         y_shear_area_ratio = 1.1 z_shear_area_ratio = 1.2 youngs_modulus = 4 shear_modulus = 5 length = 6 \
         area_of_cross_section = 7 damping_ratio = 8 matrix_of_damping_terms = {} formulation = string {MARKERS}",
        terms.join(",")
    ));
    for (name, value) in [
        ("adams_id", 8.0),
        ("ixx", 1.0),
        ("iyy", 2.0),
        ("izz", 3.0),
        ("y_shear_area_ratio", 1.1),
        ("z_shear_area_ratio", 1.2),
        ("youngs_modulus", 4.0),
        ("shear_modulus", 5.0),
        ("length", 6.0),
        ("area_of_cross_section", 7.0),
        ("damping_ratio", 8.0),
    ] {
        assert_eq!(s.number(".m.b", name), value, "{name}");
    }
    assert_eq!(s.numbers(".m.b", "matrix_of_damping_terms").len(), 21);
    let export = s.export();
    let mut again = Scene::of_export(&export);
    assert_eq!(again.export(), export);
}

/// Two parts and a place: a marker is made on each and named as Adams names markers, by class and number.
#[test]
fn two_parts_get_a_marker_each_at_the_place() {
    let mut s = Scene::beam();
    s.accept("part modify rigid_body name_and_position part_name = .m.p1 location = 0,5,0 orientation = 90,0,0");
    let parts = "i_part_name = p1 j_part_name = ground";
    s.accept(&format!("force create element_like beam beam_name = b {parts} location = 1,2,3 orientation = 10,20,30"));
    assert_eq!(s.text(".m.b", "i_marker_name"), ".m.p1.MARKER_3");
    assert_eq!(s.text(".m.b", "j_marker_name"), ".m.ground.MARKER_4");
    let [a, b, c] = [10.0_f64, 20.0, 30.0].map(f64::to_radians);
    let turned = DMat3::from_rotation_z(a) * DMat3::from_rotation_x(b) * DMat3::from_rotation_z(c);
    for marker in [".m.p1.MARKER_3", ".m.ground.MARKER_4"] {
        let at = pose(&s, marker);
        assert!(at.origin.abs_diff_eq(DVec3::new(1.0, 2.0, 3.0), ROUNDING), "{marker} {}", at.origin);
        assert!(at.rotation.abs_diff_eq(turned, ROUNDING), "{marker} {}", at.rotation);
    }
    // The first axis aimed at a point; an axis and a plane; another frame.
    s.accept(&format!("force create element_like beam beam_name = c {parts} location = 0,0,0 along_axis = 0,1,0"));
    s.accept(&format!("force create element_like beam beam_name = d {parts} location = 0,0,0 in_plane = 0,1,0, 1,0,0"));
    let aimed = |s: &Scene, beam: &str| pose(s, &s.text(beam, "j_marker_name")).rotation;
    assert!(aimed(&s, ".m.c").z_axis.abs_diff_eq(DVec3::Y, ROUNDING), "z is the axis that is aimed by default");
    assert!(aimed(&s, ".m.d").z_axis.abs_diff_eq(DVec3::Y, ROUNDING));
    s.accept(&format!("force create element_like beam beam_name = e {parts} location = 1,0,0 relative_to = p1"));
    all_close(&pose(&s, &s.text(".m.e", "i_marker_name")).origin.to_array(), &[0.0, 6.0, 0.0], ROUNDING);
}

/// Open in the help, which speaks of locations: six numbers are a place for each marker.
#[test]
fn two_places_are_one_for_each_marker() {
    let mut s = Scene::beam();
    s.accept(
        "force create element_like beam beam_name = b i_part_name = p1 j_part_name = ground location = 7,0,0, 4,0,0 length = 3",
    );
    assert_eq!(pose(&s, &s.text(".m.b", "i_marker_name")).origin, DVec3::new(7.0, 0.0, 0.0));
    assert_eq!(pose(&s, &s.text(".m.b", "j_marker_name")).origin, DVec3::new(4.0, 0.0, 0.0));
    let of_b = s.session.verify().findings.into_iter().filter(|f| f.diagnostic.message.contains("`.m.b`"));
    let codes: Vec<_> = of_b.map(|f| f.diagnostic.code).collect();
    assert_eq!(codes, ["beam/default-of-one"], "unloaded, with defaults of 1");
    s.unchanged(
        "force create element_like beam beam_name = c i_part_name = p1 j_part_name = ground location = 7,0,0, 4",
    );
}

#[test]
fn an_end_is_a_marker_or_a_part_and_never_both_or_none() {
    let mut s = Scene::beam();
    s.accept(
        "force create element_like beam beam_name = mixed i_part_name = p1 j_marker_name = marker_2 location = 5,0,0",
    );
    assert_eq!(s.text(".m.mixed", "j_marker_name"), ".m.ground.marker_2");
    for (ends, code) in [
        (format!("{MARKERS} i_part_name = p1"), "command/conflicting-arguments"),
        (format!("{MARKERS} j_part_name = p1"), "command/conflicting-arguments"),
        ("i_marker_name = marker_1".into(), "command/missing-argument"),
        ("i_part_name = p1 j_part_name = ground".into(), "command/missing-argument"),
        (
            "i_part_name = p1 j_part_name = ground location=0,0,0 orientation=0,0,0 along_axis=1,0,0".into(),
            "command/conflicting-arguments",
        ),
    ] {
        let command = format!("force create element_like beam beam_name = b {ends}");
        s.unchanged(&command);
        assert_eq!(codes(&s.session.execute(&command)), [code], "{ends}");
        assert!(!s.exists(".m.b"));
    }
}

// ---- delete ----

#[test]
fn a_beam_is_deleted_unless_something_refers_to_it() {
    for command in
        ["force delete force_name = beam1", "entity delete entity_name = .m.beam1", "force delete force_name = *"]
    {
        let mut s = Scene::beam();
        s.accept("output_control create request request_name = r f2 = \"BEAM(.m.beam1, 0, 2, 0)\"");
        s.unchanged(command);
        let report = s.session.execute(command);
        assert_eq!(codes(&report), ["name/has-dependents"], "{command}");
        assert!(s.told(&report).contains(".m.r"), "{}", s.told(&report));
        s.accept("output_control delete request request_name = r");
        s.accept(command);
        assert!(!s.exists(".m.beam1") && s.exists(".m.p1.marker_1"), "{command}");
        assert!(s.session.undo() && s.exists(".m.beam1"));
        // A marker that a beam stands on stays.
        s.unchanged("marker delete marker_name = .m.p1.marker_1");
    }
}

// ---- copy ----

#[test]
fn a_copy_has_the_values_and_expressions_and_no_id() {
    for command in [
        "force copy force_name = beam1 new_force_name = b",
        "entity copy entity_name = .m.beam1 new_entity_name = .m.b",
    ] {
        let mut s = Scene::beam();
        modify(&mut s, "adams_id = 4 ixx = 3 length = (DM(marker_1, marker_2)) comments = \"c\" formulation = string");
        s.accept(command);
        assert_eq!((s.number(".m.b", "ixx"), s.number(".m.b", "length")), (3.0, 2.0), "{command}");
        assert_eq!(s.id(".m.b"), 0, "{command}");
        assert_eq!(s.text(".m.b", "formulation"), "string");
        assert_eq!(s.text(".m.b", "i_marker_name"), ".m.p1.marker_1");
        s.accept("marker modify marker_name = marker_1 location = 9,0,0");
        assert_eq!((s.number(".m.b", "length"), s.number(".m.beam1", "length")), (9.0, 9.0), "{command}");
        modify(&mut s, "ixx = 5");
        assert_eq!(s.number(".m.b", "ixx"), 3.0, "copies live on their own");
    }
    let mut s = Scene::beam();
    s.accept("force copy force_name = beam1");
    assert!(s.exists(".m.BEAM_2"), "a name is generated: {:?}", s.session.objects("beam"));
}

// ---- attributes ----

#[test]
fn attributes_are_set_by_either_command_and_exported() {
    for command in ["force attributes force_name = beam1", "entity attributes entity_name = beam1"] {
        let mut s = Scene::beam();
        for (name, value) in [
            ("visibility", "off"),
            ("name_visibility", "on"),
            ("color", "RED"),
            ("active", "off"),
            ("dependents_active", "off"),
            ("size_of_icons", "5"),
        ] {
            s.accept(&format!("{command} {name} = {value}"));
            let export = s.export();
            let (_, attributes) = export.split_once("force attributes  &\n   force_name = .m.beam1").expect(&export);
            assert!(attributes.split("!\n").next().unwrap().contains(&format!("{name} = {value}")), "{export}");
        }
        let export = s.export();
        let mut again = Scene::of_export(&export);
        assert_eq!(again.export(), export);
    }
}

// ---- list_info ----

#[test]
fn a_listing_names_every_value_with_its_unit() {
    let mut s = Scene::beam();
    modify(&mut s, "length = (DM(marker_1, marker_2)) comments = \"note\"");
    for command in [
        "list_info force beam_name = beam1",
        "list_info force force_name = beam1",
        "list_info entity entity_name = .m.beam1",
    ] {
        s.accept(command);
        let shown = s.window().join("\n");
        for wanted in [
            "Object Name     : .m.beam1",
            "Object Type     : Beam",
            "i_marker_name   : .m.p1.marker_1",
            "length          : 2.0 (mm)",
            "ixx             : 1.0 (mm**4)",
            "youngs_modulus  : 1.0 (newton/mm**2)",
            "damping_ratio   : 0.0 (second)",
            "formulation     : linear",
            "comments        : note",
        ] {
            assert!(shown.contains(wanted), "{command}: no {wanted} in\n{shown}");
        }
    }
    s.accept("list_info force beam_name = beam1 brief = off");
    let long = s.window().join("\n");
    assert!(long.contains("= (DM(.m.p1.marker_1, .m.ground.marker_2))"), "{long}");
    assert!(!long.contains("i_part_name") && !long.contains("relative_to"), "what only creates is no value: {long}");
}
