//! The damping of a beam by its help page: the 21 or 36 terms (note 11), and what counts when the ratio
//! is given as well. The rest of the page is in `help_page.rs` and `help_page_more.rs`.

#[path = "behaviour/scene.rs"]
#[allow(dead_code)]
mod scene;

use scene::Scene;

fn modify(s: &mut Scene, values: &str) {
    s.accept(&format!("force modify element_like beam beam_name = .m.beam1 {values}"));
}

// ---- matrix_of_damping_terms (note 11) ----

fn set_terms(terms: &[f64]) -> String {
    let terms: Vec<String> = terms.iter().map(|t| format!("{t:?}")).collect();
    format!("force modify element_like beam beam_name = .m.beam1 matrix_of_damping_terms = {}", terms.join(", "))
}

/// The full matrix by columns of the lower triangle r01 to r21 of note 11.
fn full(terms: &[f64; 21]) -> Vec<f64> {
    let mut matrix = [[0.0; 6]; 6];
    let places = (0..6).flat_map(|column| (column..6).map(move |row| (row, column)));
    for ((row, column), term) in places.zip(terms) {
        (matrix[row][column], matrix[column][row]) = (*term, *term);
    }
    matrix.concat()
}

#[test]
fn half_of_the_matrix_is_enough_and_the_whole_is_taken() {
    let terms: [f64; 21] = std::array::from_fn(|k| 1.0 + k as f64);
    let mut s = Scene::beam();
    s.accept(&set_terms(&terms));
    assert_eq!(s.numbers(".m.beam1", "matrix_of_damping_terms"), terms);
    let mut whole = Scene::beam();
    whole.accept(&set_terms(&full(&terms)));
    assert_eq!(whole.numbers(".m.beam1", "matrix_of_damping_terms"), terms);
    assert_eq!(whole.export(), s.export());
    assert_eq!(whole.data_set(), s.data_set());
    // So it is with an expression that gives 36 numbers, which stays alive.
    let list = |terms: &[f64]| terms.iter().map(|t| format!("{t:?}")).collect::<Vec<_>>().join(", ");
    let mut live = Scene::beam();
    live.accept(&format!("variable create variable_name = .m.c real_value = {}", list(&full(&terms))));
    modify(&mut live, "matrix_of_damping_terms = (.m.c)");
    assert_eq!(live.numbers(".m.beam1", "matrix_of_damping_terms"), terms);
    live.accept(&format!("variable modify variable_name = .m.c real_value = {}", list(&full(&[2.0; 21]))));
    assert_eq!(live.numbers(".m.beam1", "matrix_of_damping_terms"), [2.0; 21]);
    let mut wrong = full(&terms);
    wrong[1] = 7.0;
    live.refuse(&format!("variable modify variable_name = .m.c real_value = {}", list(&wrong)));
    assert_eq!(live.numbers(".m.beam1", "matrix_of_damping_terms"), [2.0; 21]);
}

/// Both sides may differ by the rounding of whatever printed them: 1e-9 of the larger one.
#[test]
fn a_matrix_that_is_not_symmetric_is_refused_with_its_two_terms() {
    let terms: [f64; 21] = std::array::from_fn(|k| 1.0 + k as f64);
    let mut s = Scene::beam();
    let mut rounded = full(&terms);
    rounded[6] *= 1.0 + 0.9e-9;
    s.accept(&set_terms(&rounded));
    assert_eq!(s.numbers(".m.beam1", "matrix_of_damping_terms"), terms, "the lower triangle is kept");
    let mut wrong = full(&terms);
    wrong[20] = 99.0;
    let command = set_terms(&wrong);
    s.unchanged(&command);
    let report = s.session.execute(&command);
    let error = &report.diagnostics[0];
    assert_eq!(error.code, "value/not-symmetric");
    // Term 21 by columns is row 3, column 4; its twin is row 4, column 3, term 16, number r13 = 13.
    assert_eq!(
        error.message,
        "`matrix_of_damping_terms` is not symmetric: 99 in row 3, column 4 (term 21) is not 13 in row 4, column 3 (term 16)"
    );
    let shown = s.told(&report);
    let underlined: Vec<&str> = shown.lines().filter(|l| l.contains('^')).collect();
    assert!(underlined.len() == 1 && underlined[0].contains("^^^^ row 3, column 4"), "{shown}");
    assert!(shown.contains("row 4, column 3"), "{shown}");
}

#[test]
fn any_other_number_of_terms_is_refused_with_both_numbers() {
    for count in [1, 20, 22, 35, 37] {
        let mut s = Scene::beam();
        let command = set_terms(&vec![1.0; count]);
        assert_eq!(s.unchanged(&command), ["21 values are required for 'matrix_of_damping_terms'."]);
        let report = s.session.execute(&command);
        let wanted = format!("`matrix_of_damping_terms` wants 21 or 36 numbers, not {count}");
        assert_eq!(report.diagnostics[0].message, wanted);
    }
}

#[test]
fn terms_may_be_expressions() {
    let mut s = Scene::beam();
    s.accept("variable create variable_name = .m.c real_value = 2");
    let mut terms: Vec<String> = vec!["0".into(); 21];
    terms[0] = "(.m.c)".into();
    terms[20] = "(.m.c * 3)".into();
    let list = |terms: &[String]| format!("matrix_of_damping_terms = {}", terms.join(", "));
    modify(&mut s, &list(&terms));
    s.accept("variable modify variable_name = .m.c real_value = 5");
    let stored = s.numbers(".m.beam1", "matrix_of_damping_terms");
    assert_eq!((stored[0], stored[1], stored[20]), (5.0, 0.0, 15.0));
    // All 36, with an expression on one side of the diagonal only: C12 and C21.
    let mut terms: Vec<String> = vec!["0".into(); 36];
    (terms[1], terms[6]) = ("10".into(), "(.m.c * 2)".into());
    modify(&mut s, &list(&terms));
    s.accept("variable modify variable_name = .m.c real_value = 7");
    assert_eq!(s.numbers(".m.beam1", "matrix_of_damping_terms")[1], 14.0);
}

/// The page gives both in its example and does not say which counts: the matrix, with a warning.
#[test]
fn damping_given_twice_counts_as_the_matrix() {
    let mut s = Scene::beam();
    s.accept(&format!("{} damping_ratio = 2", set_terms(&[1.0; 21])));
    let find = |s: &Scene| s.session.verify().findings.into_iter().find(|f| f.diagnostic.code == "beam/damping-twice");
    let found = find(&s).unwrap();
    assert!(found.diagnostic.notes[0].contains("`matrix_of_damping_terms` is used and `damping_ratio`, 2, is not"));
    let verified = s.session.verify();
    s.session.fix(&verified);
    assert_eq!(s.number(".m.beam1", "damping_ratio"), 0.0);
    assert_eq!(s.numbers(".m.beam1", "matrix_of_damping_terms"), [1.0; 21]);
    assert!(find(&s).is_none());
}
