//! One test per rule of run-time functions.

mod common;
use common::function;
use flexure_syntax::function::{FunctionKind, parse};
use text::FileId;

fn codes(text: &str) -> Vec<(&'static str, &str)> {
    parse(FileId(0), text, 0).1.iter().map(|d| (d.code, &text[d.primary.as_ref().unwrap().span.range()])).collect()
}

#[test]
fn operators_bind_in_their_order() {
    for (text, expected) in [
        ("a+b*c-d/e", "(- (+ a (* b c)) (/ d e))"),
        ("-x**2", "(- (** x 2.0))"),
        ("2*-3", "(* 2.0 (- 3.0))"),
        ("2**3**2", "(** 2.0 (** 3.0 2.0))"),
        ("2**-3**2", "(** 2.0 (- (** 3.0 2.0)))"),
        ("-2*3", "(* (- 2.0) 3.0)"),
        ("+(a-b)", "(- a b)"),
        ("a - -b", "(- a (- b))"),
        ("-.002*WZ(.m.p.tc)", "(* (- 0.002) WZ(.m.p.tc))"),
    ] {
        assert_eq!(function(text), expected, "{text}");
    }
}

#[test]
fn a_d_turns_degrees_into_radians() {
    assert_eq!(function("180D"), format!("{:?}", std::f64::consts::PI));
    assert_eq!(function("90.0d*TIME"), format!("(* {:?} TIME)", std::f64::consts::FRAC_PI_2));
    assert_eq!(function("1.8E2D+1"), format!("(+ {:?} 1.0)", std::f64::consts::PI));
}

#[test]
fn calls_and_names_of_objects() {
    assert_eq!(function("step(TIME, 0,0 , 1,.m.\"odd one\".x)"), "step(TIME 0.0 0.0 1.0 .m.\"odd one\".x)");
    assert_eq!(function("CPU()"), "CPU()");
    assert_eq!(function("VARVAL(größe) + $x"), "(+ VARVAL(größe) $x)");
}

#[test]
fn an_if_has_a_colon_behind_its_condition() {
    assert_eq!(function("If(TIME-4.0: 0, 0, IF(x:1,2,3))"), "If((- TIME 4.0) 0.0 0.0 IF(x 1.0 2.0 3.0))");
    assert_eq!(codes("IF(x, 1, 2, 3)"), [("function/unexpected", ",")]);
    assert_eq!(codes("ABS(x: 1)"), [("function/unexpected", ":")]);
}

#[test]
fn a_function_may_span_lines() {
    assert_eq!(function(" DX(1,\r\n 2 ,\t3)\n * 2 "), "(* DX(1.0 2.0 3.0) 2.0)");
}

#[test]
fn troubles_point_at_the_first_sign_that_cannot_stand() {
    assert_eq!(codes(""), [("function/incomplete", "")]);
    assert_eq!(codes("1 +"), [("function/incomplete", "")]);
    assert_eq!(codes("SIN(1"), [("function/incomplete", "")]);
    assert_eq!(codes("1 2"), [("function/unexpected", "2")]);
    assert_eq!(codes("(1))"), [("function/unexpected", ")")]);
    assert_eq!(codes("3x"), [("function/unexpected", "x")]);
    assert_eq!(codes(".m.\"odd"), [("function/unclosed-quote", "\"")]);
    assert_eq!(codes("1E999"), [("function/number-out-of-range", "1E999")]);
}

#[test]
fn nesting_and_height_are_limited_and_nothing_overflows() {
    for open in ["(", "f(", "-", "2**", "IF(1:"] {
        for count in [150, 100_000] {
            let (tree, diagnostics) = parse(FileId(0), &open.repeat(count), 0);
            assert_eq!((diagnostics.len(), tree.kind), (1, FunctionKind::Broken), "{open}");
        }
    }
    for operator in ["+1", "*x"] {
        let (_, diagnostics) = parse(FileId(0), &format!("a{}", operator.repeat(100_000)), 0);
        assert_eq!(diagnostics[0].code, "function/nested-too-deeply");
        assert!(parse(FileId(0), &format!("a{}", operator.repeat(900)), 0).1.is_empty());
    }
}

#[test]
fn the_offset_moves_every_span() {
    let (tree, _) = parse(FileId(2), " a + b", 50);
    assert_eq!((tree.span.file, tree.span.range()), (FileId(2), 51..56));
}
