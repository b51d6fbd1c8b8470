//! Values of beams: expressions, units, ids, and how they are written.

use crate::scene::{Scene, close};

fn set(s: &mut Scene, values: &str) {
    s.accept(&format!("force modify element_like beam beam_name = .m.beam1 {values}"));
}

// Case 19, documented: the lower triangle by columns, both sides of the diagonal equal.
#[test]
fn the_damping_matrix_is_given_by_columns_of_its_lower_triangle() {
    let mut s = Scene::beam();
    let terms: Vec<String> = (1..=21).map(|n| n.to_string()).collect();
    set(&mut s, &format!("matrix_of_damping_terms = {}", terms.join(",")));
    let stored = s.numbers(".m.beam1", "matrix_of_damping_terms");
    assert_eq!(stored, (1..=21).map(f64::from).collect::<Vec<_>>());
    // The statement of the dataset has them in the same order; a program for the solver reads
    // 1 to 6 as the first column.
    let data_set = s.data_set();
    let at = data_set.find("CMATRIX").expect(&data_set);
    let written: Vec<f64> = data_set[at..]
        .split(['=', ',', '\n', ' '])
        .skip(1)
        .filter(|w| !w.is_empty())
        .map_while(|w| w.parse().ok())
        .collect();
    assert_eq!(written[..21], stored, "{data_set}");
}

// Case 23, observed.
#[test]
fn a_constant_expression_is_kept() {
    let mut s = Scene::beam();
    set(&mut s, "ixx = (2*2)");
    assert_eq!(s.number(".m.beam1", "ixx"), 4.0);
    assert_eq!(s.expression(".m.beam1", "ixx").as_deref(), Some("2 * 2"));
    let export = s.export();
    let (_, late) = export.split_once("Expression definitions").expect("the block");
    assert!(late.contains("ixx = (2 * 2)"), "{late}");
}

// Case 24, observed: 24*1.016³/12 + 1.016*24³/12, 1.016*24³/12 and 1.016*24 by hand.
#[test]
fn sections_are_computed() {
    let mut s = Scene::beam();
    set(
        &mut s,
        "ixx = (24.0/12*1.016**3 + 1.016/12*24.0**3) iyy = (1.016/12*24.0**3) area_of_cross_section = (1.016*24.0)",
    );
    close(s.number(".m.beam1", "ixx"), 1_172.529_544_192, 1e-9); // rounding of a double near 1e3
    close(s.number(".m.beam1", "iyy"), 1_170.432, 1e-9);
    close(s.number(".m.beam1", "area_of_cross_section"), 24.384, 1e-12);
}

// Case 25, observed.
#[test]
fn a_tube_has_the_area_the_export_shows() {
    let mut s = Scene::beam();
    set(&mut s, "area_of_cross_section = ((0.4167**2 - 0.3333**2)*PI/4)");
    assert!(s.export().contains("area_of_cross_section = 4.9126655121E-02"));
}

// Case 26, observed; that it follows is documented.
#[test]
fn a_modulus_follows_its_variable() {
    let mut s = Scene::beam();
    s.accept("variable create variable_name=.m.E units=\"pressure\" real_value=2.0E5");
    set(&mut s, "youngs_modulus=(.m.E) shear_modulus=(0.385*.m.E)");
    assert_eq!(s.number(".m.beam1", "youngs_modulus"), 2.0e5);
    s.accept("variable modify variable_name=.m.E real_value=1.0E5");
    assert_eq!(s.number(".m.beam1", "youngs_modulus"), 1.0e5);
    close(s.number(".m.beam1", "shear_modulus"), 3.85e4, 1e-9);
}

// Case 27, documented.
#[test]
fn eval_takes_the_value_of_now() {
    let mut s = Scene::beam();
    s.accept("variable create variable_name=.m.E units=\"pressure\" real_value=2.0E5");
    set(&mut s, "youngs_modulus=(eval(.m.E))");
    s.accept("variable modify variable_name=.m.E real_value=1.0E5");
    assert_eq!(s.number(".m.beam1", "youngs_modulus"), 2.0e5);
    assert!(!s.export().contains("Expression definitions"));
}

// Cases 28 and 29, documented; the numbers follow from 1 m = 1000 mm.
#[test]
fn other_units_show_the_same_beam() {
    let mut s = Scene::beam();
    set(&mut s, "damping_ratio = 0.25 y_shear_area_ratio = 1.5");
    let model = s.session.model().unwrap();
    let beam = s.session.database().below(model, "beam")[0];
    let physical = |s: &Scene, name: &str| s.session.database().si(beam, name).unwrap();
    let names = ["length", "area_of_cross_section", "ixx", "youngs_modulus", "shear_modulus"];
    let before = names.map(|n| physical(&s, n));
    s.accept("defaults units length = meter");
    for (name, value) in [
        ("length", 0.002),
        ("area_of_cross_section", 1e-6),
        ("ixx", 1e-12),
        ("youngs_modulus", 1e6),
        ("shear_modulus", 1e6),
        ("damping_ratio", 0.25),
        ("y_shear_area_ratio", 1.5),
    ] {
        close(s.number(".m.beam1", name), value, value * 1e-14); // one conversion
    }
    for (name, before) in names.into_iter().zip(before) {
        close(physical(&s, name), before, before * 1e-14);
    }
    set(&mut s, "length = 3");
    s.accept("defaults units length = mm");
    close(s.number(".m.beam1", "length"), 3000.0, 1e-10);
}

// Case 30, observed with other lengths; for a beam inferred.
#[test]
fn a_length_with_its_unit_is_kept_as_written() {
    let mut s = Scene::beam();
    set(&mut s, "length = (2cm)");
    close(s.number(".m.beam1", "length"), 20.0, 1e-12);
    let export = s.export();
    let (_, late) = export.split_once("Expression definitions").expect("the block");
    assert!(late.contains("length = (2cm)"), "{late}");
}

// Case 31, documented.
#[test]
fn a_beam_without_id_gets_one_with_the_dataset_and_keeps_it() {
    let mut s = Scene::beam();
    set(&mut s, "adams_id = 0");
    assert!(s.data_set().contains("BEAM/1"));
    assert_eq!(s.number(".m.beam1", "adams_id"), 1.0);
    assert!(s.data_set().contains("BEAM/1"));
    let export = s.export();
    let beam = export.split("force create element_like beam").nth(1).unwrap();
    assert!(beam.split("!\n").next().unwrap().contains("adams_id = 1"), "{beam}");
    s.accept("list_info force beam_name = .m.beam1 brief = off");
    let shown = s.window();
    assert!(shown.iter().any(|l| l.to_lowercase().contains("id") && l.ends_with(": 1")), "{shown:?}");
}

// Case 32, documented.
#[test]
fn an_id_stands_in_the_dataset() {
    let mut s = Scene::beam();
    set(&mut s, "adams_id = 12");
    assert!(s.data_set().contains("\nBEAM/12\n"));
}

// Case 33, observed.
#[test]
fn the_statement_of_a_beam_has_its_lines_in_order() {
    let mut s = Scene::beam();
    set(&mut s, "adams_id = 1 youngs_modulus = 190000 shear_modulus = 75000 damping_ratio = .01");
    let data_set = s.data_set();
    let lines: Vec<&str> = data_set.lines().collect();
    let at = lines.iter().position(|l| *l == "BEAM/1").expect(&data_set);
    assert!(lines[..at].iter().rev().take(2).any(|l| l.starts_with('!') && l.contains("adams_view_name='beam1'")));
    let keys: Vec<&str> = lines[at + 1..].iter().map_while(|l| l.strip_prefix(", ")).collect();
    assert!(keys[0].starts_with("I = ") && keys[1].starts_with("J = "), "{keys:?}");
    let rest = [
        "LENGTH = 2",
        "IXX = 1",
        "IYY = 1",
        "IZZ = 1",
        "AREA = 1",
        "EMODULUS = 1.9E+05",
        "GMODULUS = 75000",
        "CRATIO = 0.01",
        "FORMULATION = LINEAR",
    ];
    assert_eq!(keys[2..], rest);
}

// Case 34, observed.
#[test]
fn a_command_file_has_the_parameters_of_a_beam_in_order() {
    let mut s = Scene::beam();
    set(&mut s, "adams_id = 3");
    let export = s.export();
    let at = export.find("force create element_like beam").expect(&export);
    let lines: Vec<&str> = export[at..].lines().collect();
    assert_eq!(lines[0], "force create element_like beam  &");
    assert_eq!(lines[1], "   beam_name = .m.beam1  &");
    let names: Vec<&str> = lines[1..].iter().map_while(|l| l.trim().split_once(" = ").map(|(n, _)| n)).collect();
    let wanted = [
        "beam_name",
        "adams_id",
        "i_marker_name",
        "j_marker_name",
        "length",
        "area_of_cross_section",
        "y_shear_area_ratio",
        "z_shear_area_ratio",
        "youngs_modulus",
        "shear_modulus",
        "ixx",
        "iyy",
        "izz",
        "damping_ratio",
        "formulation",
    ];
    assert_eq!(names, wanted);
    assert_eq!(lines[names.len() + 1], "!");
}

// Case 35, observed.
#[test]
fn numbers_are_written_as_adams_writes_them() {
    let mut s = Scene::beam();
    for (typed, written) in [
        ("75000", "7.5E+04"),
        ("190000", "1.9E+05"),
        ("24.384", "24.384"),
        ("0", "0.0"),
        ("0.01", "1.0E-02"),
        ("6.8544971902", "6.8544971902"),
        ("1170.432", "1170.432"),
    ] {
        set(&mut s, &format!("damping_ratio = {typed}"));
        let line = format!("damping_ratio = {written}  &\n");
        assert!(s.export().contains(&line), "{line}");
    }
}

// Case 50, inferred: the command takes it, with a warning; a run does not.
#[test]
fn a_beam_without_length_is_refused_by_a_run_only() {
    for length in ["0", "-1"] {
        let mut s = Scene::beam();
        let report = s.accept(&format!("force modify element_like beam beam_name = .m.beam1 length = {length}"));
        assert!(report.diagnostics.iter().any(|d| d.code == "value/outside-limit"));
        assert_eq!(s.number(".m.beam1", "length"), length.parse::<f64>().unwrap());
        let found = s.session.verify().findings;
        assert!(found.iter().any(|f| f.diagnostic.message.contains("length")), "{found:?}");
        assert!(s.session.execute("simulation single_run equilibrium").failed > 0);
    }
}

// Case 51, observed in exports.
#[test]
fn no_shear_and_no_damping_are_accepted() {
    let mut s = Scene::beam();
    let report =
        s.accept("force modify element_like beam beam_name = .m.beam1 y_shear_area_ratio = 0.0 damping_ratio = 0.0");
    assert!(report.diagnostics.is_empty(), "{}", s.told(&report));
}
