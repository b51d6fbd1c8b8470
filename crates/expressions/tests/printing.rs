//! The printed form: what exports show, and that reading it gives the same expression.

mod common;
use common::*;
use model::{BinaryOperator, Expression, Node, UnaryOperator};
use proptest::prelude::*;

/// Truth: expressions as exports of Adams show them; the left column is typed by hand.
#[test]
fn text_is_normalised_as_exports_show_it() {
    let mut f = fixture();
    variable(&mut f.db, "dv", "real_value", model::Value::Number(2.0));
    for (typed, printed) in [
        ("loc_relative_to({0,0,0},ref)", "LOC_RELATIVE_TO({0, 0, 0}, .m.ground.ref)"),
        ("24.0/12*1.016**3+1.016/12*24.0**3", "24.0 / 12 * 1.016**3 + 1.016 / 12 * 24.0**3"),
        ("(0.4167**2 - 0.3333**2)*pi/4", "(0.4167**2 - 0.3333**2) * PI / 4"),
        ("-(31.0/4-1.0)", "-(31.0 / 4 - 1.0)"),
        ("0.385*.m.dv", "0.385 * .m.dv"),
        ("-dv/2", "-.m.dv / 2"),
        ("2*10.0cm", "2 * 10.0cm"),
        ("7801.0(kg/meter**3)", "7801.0(kg/meter**3)"),
        ("2.07E+11(Newton/meter**2)", "2.07E+11(Newton/meter**2)"),
        ("6e-2meter", "6.0E-02meter"),
        (".5", "0.5"),
        ("8D", "8d"),
        ("\"test\"//\".LateralRef\"", "\"test\" // \".LateralRef\""),
        ("(none)", "NONE"),
        ("p1.m1.loc[1]", ".m.p1.m1.location[1]"),
        (".m.b.i", ".m.b.i"),
        ("! db_exists(\"x\")", "!DB_EXISTS(\"x\")"),
        ("1-(2-3)", "1 - (2 - 3)"),
        ("{[1,2],[3,4]}", "{[1, 2], [3, 4]}"),
        ("(1>2)? 3:4", "1 > 2 ? 3 : 4"),
    ] {
        let expression = bound(&f.db, typed);
        assert_eq!(flexure_expressions::print(&expression, &f.db), printed, "{typed}");
        assert_eq!(bound(&f.db, printed), expression, "{printed}");
    }
}

fn number() -> impl Strategy<Value = Node> {
    let unit = prop_oneof![
        4 => Just(None),
        1 => Just(Some("mm")),
        1 => Just(Some("d")),
        1 => Just(Some("(kg/meter**3)")),
    ];
    let value = prop_oneof![
        (0_u32..100_000).prop_map(|i| (f64::from(i), i.to_string())),
        (0.0_f64..1e20).prop_map(|x| (x, flexure_expressions::number_text(x))),
        (0.0_f64..1e-6).prop_map(|x| (x, flexure_expressions::number_text(x))),
    ];
    (value, unit).prop_map(|((value, text), unit)| Node::Number {
        value,
        text: text.into(),
        unit: unit.map(Into::into),
    })
}

fn called(node: Node) -> Node {
    match node {
        Node::Number { .. } | Node::Constant(_) | Node::Nothing | Node::Text(_) | Node::Object(_) => {
            Node::Call { function: "STOO".into(), arguments: vec![node] }
        }
        other => other,
    }
}

fn tree() -> impl Strategy<Value = Node> {
    let objects = {
        let f = fixture();
        vec![Node::Object(f.m1), Node::Object(f.p1), Node::Object(f.beam)]
    };
    let leaf = prop_oneof![
        number(),
        "[ -~]{0,6}".prop_map(Node::Text),
        proptest::sample::select(objects),
        proptest::sample::select(vec!["PI", "DTOR", "RTOD", "TIME"]).prop_map(Node::Constant),
        Just(Node::Nothing),
    ];
    leaf.prop_recursive(5, 40, 4, |inner| {
        use BinaryOperator as B;
        let operators = vec![
            B::Power,
            B::Multiply,
            B::Divide,
            B::Add,
            B::Subtract,
            B::Concatenate,
            B::Less,
            B::LessEqual,
            B::Greater,
            B::GreaterEqual,
            B::Equal,
            B::NotEqual,
            B::And,
            B::Or,
        ];
        let signs = vec![UnaryOperator::Negate, UnaryOperator::Plus, UnaryOperator::Not];
        let boxed = || inner.clone().prop_map(Box::new);
        prop_oneof![
            (proptest::sample::select(operators), boxed(), boxed()).prop_map(|(o, a, b)| Node::Binary(o, a, b)),
            (proptest::sample::select(signs), boxed()).prop_map(|(o, a)| Node::Unary(o, a)),
            (boxed(), boxed(), boxed()).prop_map(|(c, a, b)| Node::Conditional(c, a, b)),
            proptest::collection::vec(inner.clone(), 0..4).prop_map(Node::Array),
            proptest::collection::vec(inner.clone(), 0..4).prop_map(Node::Row),
            inner.clone().prop_map(|n| Node::Call { function: "SIN".into(), arguments: vec![n] }),
            (inner.clone(), inner.clone())
                .prop_map(|(a, b)| Node::Call { function: "MOD".into(), arguments: vec![a, b] }),
            // Behind a plain number or name a bracket or dot would read as part of it.
            (inner.clone(), inner.clone()).prop_map(|(a, i)| Node::Index(Box::new(called(a)), vec![i])),
            inner.clone().prop_map(|a| Node::Attribute(Box::new(called(a)), "location".into())),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_reads_as_the_same_expression(root in tree()) {
        let db = fixture().db;
        let expression = Expression { root };
        let text = flexure_expressions::print(&expression, &db);
        prop_assert_eq!(&bound(&db, &text), &expression, "{}", text);
    }

    /// Whatever is typed, binding and evaluating end without a panic.
    #[test]
    fn any_tree_evaluates_or_says_why(root in tree()) {
        let db = fixture().db;
        let sources = text::Sources::default();
        let _ = flexure_expressions::evaluate(&Expression { root }, &flexure_expressions::Scope::new(&db, &sources));
    }

    #[test]
    fn any_arguments_give_a_value_or_an_error(
        name in proptest::sample::select(vec![
            "LOC_GLOBAL", "ORI_ALL_AXES", "ORI_IN_PLANE", "STR_SUBSTR", "STR_DELETE", "STR_INSERT", "STR_SPRINTF",
            "STR_MATCH", "STR_SPLIT", "SERIES", "SERIES2", "FIRST_N", "LAST_N", "RESHAPE", "INTERP1", "POLYFIT", "INVERSE",
            "DET", "NORM", "TMAT", "MOD", "SORT", "VAL", "DB_DESCENDANTS", "UNITS_VALUE", "EXPR_STRING", "STEP", "CHR",
        ]),
        arguments in proptest::collection::vec(tree(), 0..5),
    ) {
        let db = fixture().db;
        let sources = text::Sources::default();
        let root = Node::Call { function: name.into(), arguments };
        let _ = flexure_expressions::evaluate(&Expression { root }, &flexure_expressions::Scope::new(&db, &sources));
    }
}
