//! What is refused, with which words and where.

mod support;

use flexure_functions::compile;
use support::{Bench, errors};
use syntax::function::{FunctionExpression, FunctionKind};
use text::{FileId, Span};

fn codes(text: &str) -> Vec<(&'static str, String)> {
    errors(text).into_iter().map(|d| (d.code, d.message)).collect()
}

#[test]
fn unknown_functions_get_a_suggestion() {
    let found = errors("HAVSINE(TIME,0,0,1,1)");
    assert_eq!(found[0].code, "function/unknown-function");
    assert_eq!(found[0].helps[0].text, "did you mean `HAVSIN`?");
    assert_eq!(found[0].primary.as_ref().map(|l| l.span.range()), Some(0..7));
}

#[test]
fn wrong_numbers_of_arguments_are_refused() {
    assert_eq!(
        codes("step(TIME,0,0,1)"),
        [("function/wrong-argument-count", "`STEP` takes 5 arguments, but 4 are given".to_string())]
    );
    assert_eq!(codes("DX()")[0].1, "`DX` takes 1 to 3 arguments, but 0 are given");
    assert_eq!(codes("ABS(1,2)")[0].1, "`ABS` takes 1 argument, but 2 are given");
    let coefficients = vec!["1"; 32].join(",");
    assert_eq!(codes(&format!("POLY(TIME,0,{coefficients})"))[0].0, "function/wrong-argument-count");
}

#[test]
fn objects_of_the_wrong_kind_are_refused() {
    assert_eq!(codes("DX(foo)"), [("function/unknown-object", "no marker named `foo`".to_string())]);
    assert_eq!(codes("BEAM(x,0,1,0)")[0].1, "no element for BEAM named `x`");
    assert_eq!(codes("DX(1+1)")[0].0, "function/wrong-argument");
    assert_eq!(codes("DX(0, 1)")[0].1, "argument 1 of `DX` must be a marker, not 0");
    assert_eq!(codes("DX(1.5)")[0].0, "function/wrong-argument");
    assert_eq!(codes("INCANG(1, 0, 2)")[0].0, "function/wrong-argument");
}

#[test]
fn flags_and_components_must_be_in_range() {
    assert_eq!(codes("BEAM(e,2,1,0)")[0].1, "this argument must be 0 for the I marker or 1 for the J marker");
    assert_eq!(codes("BEAM(e,0,9,0)")[0].0, "function/wrong-argument");
    assert_eq!(codes("BEAM(e,TIME,1,0)")[0].0, "function/wrong-argument");
}

#[test]
fn functions_that_are_not_there_yet_say_so_by_name() {
    let names = "VARVAL ARYVAL DIF DIF1 AKISPL CUBSPL CURVE SENVAL CONTACT USER NFORCE FRICTION DELAY INVPSD PINVAL";
    for name in names.split(' ') {
        let found = errors(&format!("2*{name}(1)"));
        assert_eq!(found[0].code, "function/not-supported");
        assert_eq!(found[0].message, format!("the function `{name}` is not supported yet"));
        assert_eq!(found[0].notes.len(), 1, "the note says why");
    }
}

#[test]
fn what_can_never_be_a_number_is_refused() {
    assert_eq!(codes("TIME + 1/0"), [("function/not-finite", "a part of the function is infinite".to_string())]);
    assert_eq!(codes("SQRT(-4)*TIME")[0].1, "a part of the function is not a number");
    assert_eq!(codes("TIMES")[0].0, "function/unknown-name");
}

#[test]
fn every_trouble_is_reported_not_only_the_first() {
    assert_eq!(codes("FOO(1) + DX(bar) * STEP(1)").len(), 3);
    assert_eq!(codes("BEAM(x, 2, 9, nothing)").len(), 4);
}

#[test]
fn hostile_nesting_is_refused_without_a_crash() {
    let span = Span::new(FileId(0), 0, 1);
    let mut tree = FunctionExpression { span, kind: FunctionKind::Number(1.0) };
    for _ in 0..1000 {
        tree = FunctionExpression { span, kind: FunctionKind::Negate(Box::new(tree)) };
    }
    let found = compile(&tree, &mut Bench).expect_err("too deep");
    assert_eq!(found[0].code, "function/too-deep");
}
