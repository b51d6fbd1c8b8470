//! One test per rule of expressions in commands.

mod common;
use common::{codes, tree};
use flexure_syntax::command::{ExpressionKind, parse_expression};
use text::FileId;

#[test]
fn operators_bind_in_their_order() {
    for (text, expected) in [
        ("a + b * c", "(+ a (* b c))"),
        ("a - b - c", "(- (- a b) c)"),
        ("a / b * c", "(* (/ a b) c)"),
        ("-a ** b", "(- (** a b))"),
        ("a ** -b", "(** a (- b))"),
        ("a ** b ** c", "(** a (** b c))"),
        ("-a * b", "(* (- a) b)"),
        ("2*-3", "(* 2.0 (- 3.0))"),
        ("! a == b", "(== (! a) b)"),
        ("tmp//j+(i-1)*4", "(// tmp (+ j (* (- i 1.0) 4.0)))"),
        ("a // b == c", "(== (// a b) c)"),
        ("a < b == c >= d", "(== (< a b) (>= c d))"),
        ("a && b || c && !d", "(|| (&& a b) (&& c (! d)))"),
        ("a != b", "(!= a b)"),
        ("a <= b", "(<= a b)"),
        ("a > b ? c : d ? e : f", "(? (> a b) c (? d e f))"),
        ("(.s==1)? 'off':'on'", "(? (== .s 1.0) \"off\" \"on\")"),
        ("(a + b) * c", "(* (+ a b) c)"),
        ("+a", "(+ a)"),
    ] {
        assert_eq!(tree(text), expected, "{text}");
    }
}

#[test]
fn numbers_take_units_directly_behind_them() {
    assert_eq!(tree("6inch"), "6.0<inch>");
    assert_eq!(tree("7801.0(kg/meter**3)"), "7801.0<kg/meter**3>");
    assert_eq!(tree("2.07E+11(Newton/meter**2) * 2"), "(* 207000000000.0<Newton/meter**2> 2.0)");
    assert_eq!(tree("90d - 1.0E-002meter"), "(- 90.0<d> 0.01<meter>)");
    assert_eq!(tree("5. + .5"), "(+ 5.0 0.5)");
    assert_eq!(tree("5.mm"), "5.0<mm>");
}

#[test]
fn names_calls_indices_and_attributes() {
    assert_eq!(tree(".m.\"odd name\".x.location[1]"), "(at .m.\"odd name\".x.location 1.0)");
    assert_eq!(
        tree("eval(stoo(.mdi.t // \".s\").location[1]-20)"),
        "eval((- (at (of stoo((// .mdi.t \".s\")) location) 1.0) 20.0))"
    );
    assert_eq!(tree("m[1, 2].a.b"), "(of (at m 1.0 2.0) a.b)");
    assert_eq!(tree("m[4:6]"), "(at m :(4.0 6.0))");
    assert_eq!(tree("m[1, i+1:j]"), "(at m 1.0 :((+ i 1.0) j))");
    assert_eq!(tree("time()"), "time()");
    assert_eq!(tree("ABS ( x )"), "ABS(x)");
    assert_eq!(tree("IF(x: 1, 2, a ? b : c)"), "IF(x 1.0 2.0 (? a b c))");
    assert_eq!(tree("if(x, 1, 2, 3)"), "if(x 1.0 2.0 3.0)");
    assert_eq!(tree("$_self.value"), "$_self.value");
    assert_eq!(tree("(none)"), "none");
}

#[test]
fn arrays_rows_and_tuples() {
    assert_eq!(tree("LOC_RELATIVE_TO({0, .m.r*2, -1}, .m.p.a)"), "LOC_RELATIVE_TO({0.0 (* .m.r 2.0) (- 1.0)} .m.p.a)");
    assert_eq!(tree("{[1,2],[3,4]}"), "{[1.0 2.0] [3.0 4.0]}");
    assert_eq!(tree("{{7,5,0},{15,11,0}}"), "{{7.0 5.0 0.0} {15.0 11.0 0.0}}");
    assert_eq!(tree("{}"), "{}");
    assert_eq!(tree("0.0, 1, x"), "(tuple 0.0 1.0 x)");
    assert_eq!(tree("f((1, 2))"), "f((tuple 1.0 2.0))");
}

#[test]
fn strings_of_both_kinds() {
    assert_eq!(tree(r#""a \"b\"" // 'c "d"'"#), r#"(// "a \"b\"" "c \"d\"")"#);
}

#[test]
fn troubles_point_at_the_first_sign_that_cannot_stand() {
    for (text, code, at) in [
        ("a b = (1 +)", "syntax/incomplete-expression", ""),
        ("a b = ()", "syntax/incomplete-expression", ""),
        ("a b = (1 + * 2)", "syntax/unexpected-in-expression", "*"),
        ("a b = (f(1;2))", "syntax/unexpected-in-expression", ";"),
        ("a b = ({1, 2)", "syntax/incomplete-expression", ""),
        ("a b = (x y)", "syntax/unexpected-in-expression", "y"),
        ("a b = (x [1])", "syntax/unexpected-in-expression", "["),
        ("a b = (a ? b)", "syntax/incomplete-expression", ""),
        ("a b = (1 = 2)", "syntax/unexpected-in-expression", "="),
    ] {
        assert_eq!(codes(text), [(code, at)], "{text}");
    }
}

#[test]
fn a_broken_expression_does_not_hide_the_next_trouble() {
    assert_eq!(codes("a b = (1 +), (2 *) c = (3 /)").len(), 3);
}

#[test]
fn nesting_and_height_are_limited_and_nothing_overflows() {
    for open in ["(", "{", "[", "f(", "-", "!", "2**", "a?", "a[", "+(", "1?1:"] {
        for count in [150, 100_000] {
            let text = open.repeat(count);
            let (tree, diagnostics) = parse_expression(FileId(0), &text, 0);
            assert_eq!(diagnostics.len(), 1, "{open}");
            assert_eq!(tree.kind, ExpressionKind::Broken);
        }
    }
    assert!(parse_expression(FileId(0), &format!("{}1{}", "(".repeat(150), ")".repeat(150)), 0).1.is_empty());
    assert!(parse_expression(FileId(0), &format!("1{}", "+1".repeat(900)), 0).1.is_empty());
    for operator in ["+1", "*1", "//1", "&&1", ".a[1]", "[1]"] {
        let (_, diagnostics) = parse_expression(FileId(0), &format!("a{}", operator.repeat(100_000)), 0);
        assert_eq!(diagnostics.len(), 1, "{operator}");
        assert_eq!(diagnostics[0].code, "syntax/nested-too-deeply");
    }
}

#[test]
fn an_offset_moves_every_span() {
    let (tree, _) = parse_expression(FileId(3), "a + b", 100);
    assert_eq!((tree.span.file, tree.span.range()), (FileId(3), 100..105));
}
