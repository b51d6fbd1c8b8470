//! The public list of functions.

mod common;
use common::*;

/// Truth: the counts of the documented calls; every entry can be told apart and explains itself.
#[test]
fn every_function_is_listed_with_its_arguments() {
    let all: Vec<_> = flexure_expressions::functions().collect();
    assert!(all.len() > 180);
    let mut names: Vec<&str> = all.iter().map(|f| f.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all.len(), "a name is listed twice");
    for f in &all {
        assert!(f.name.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_'), "{}", f.name);
        assert!(!f.doc.is_empty() && !f.doc.contains('\n') && !f.doc.ends_with('.'), "{}", f.name);
        assert!(f.least <= f.most && !f.group.is_empty(), "{}", f.name);
        assert!(!flexure_expressions::refused_functions().contains(&f.name), "{} is refused as well", f.name);
    }
    let of = |name: &str| all.iter().find(|f| f.name == name).map(|f| (f.least, f.most, f.group));
    assert_eq!(of("LOC_RELATIVE_TO"), Some((2, 2, "location")));
    assert_eq!(of("DX"), Some((1, 3, "modelling")));
    assert_eq!(of("INTERP1"), Some((3, 4, "interpolation")));
    assert_eq!(of("GETCWD"), Some((0, 0, "file")));
}

/// Truth: the text of the real log for LOC_RELATIVE_TO; a listed count is the count that is checked.
#[test]
fn listed_counts_are_those_that_are_checked() {
    let db = fixture().db;
    for f in flexure_expressions::functions().filter(|f| f.name != "EVAL" && f.name != "IF") {
        let call = format!("{}({})", f.name, vec!["1"; f.most + 1].join(","));
        let error = error(&db, &call);
        assert_eq!(error.code, "expression/wrong-argument-count", "{call}: {}", error.message);
        assert!(
            error
                .adams_text
                .iter()
                .any(|l| l == &format!("The function {} expects {} arguments, found {}", f.name, f.most, f.most + 1)),
            "{call}: {:?}",
            error.adams_text
        );
    }
}
