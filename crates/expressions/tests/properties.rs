//! Properties: printing and reading, hostile text, re-evaluation of random chains.

mod common;
use common::*;
use flexure_expressions::{Bound, evaluate, number_text, print, recompute, restructure};
use model::{Database, Value};
use proptest::prelude::*;
use text::Sources;

/// Texts of expressions of the whole grammar on the fixture.
fn expressions() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        (0_i64..1000).prop_map(|i| i.to_string()),
        (0.0..1e6_f64).prop_map(number_text),
        "[a-z \"\\\\]{0,4}".prop_map(|t| format!("\"{}\"", t.replace('\\', "\\\\").replace('"', "\\\""))),
        Just("PI".to_string()),
        Just("30d".to_string()),
        Just("2.5(newton/mm**2)".to_string()),
        Just(".m.p1.m1".to_string()),
        Just("p1.m1.location[2]".to_string()),
        Just("(none)".to_string()),
    ];
    leaf.prop_recursive(4, 40, 4, |inner| {
        let sign =
            prop::sample::select(vec!["+", "-", "*", "/", "**", "//", "<", "<=", ">", ">=", "==", "!=", "&&", "||"]);
        prop_oneof![
            (inner.clone(), sign, inner.clone()).prop_map(|(a, s, b)| format!("({a}) {s} ({b})")),
            (inner.clone(), prop::sample::select(vec!["+", "-"]), inner.clone())
                .prop_map(|(a, s, b)| format!("{a}{s}{b}")),
            (prop::sample::select(vec!["-", "+", "!"]), inner.clone()).prop_map(|(s, a)| format!("{s}({a})")),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(c, a, b)| format!("({c}) ? ({a}) : ({b})")),
            prop::collection::vec(inner.clone(), 0..4).prop_map(|l| format!("{{{}}}", l.join(","))),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("{{[{a},{b}],[{b},{a}]}}")),
            (inner.clone(), inner.clone()).prop_map(|(a, i)| format!("SQRT({a})[{i}]")),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, i, j)| format!("({{{a}}})[{i}:{j}]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("STOO({a}).adams_id + IF({b}: 1, {a}, 3)")),
            (inner.clone(), inner).prop_map(|(a, b)| format!("LOC_RELATIVE_TO({{{a}, 0, {b}}}, .m.ground.ref)")),
        ]
    })
}

fn as_bound(db: &Database, text: &str) -> Option<model::Expression> {
    let mut sources = Sources::default();
    let file = sources.add("t.cmd", text);
    let (tree, errors) = syntax::command::parse_expression(file, text, 0);
    if !errors.is_empty() {
        return None;
    }
    match flexure_expressions::bind(&tree, &flexure_expressions::Scope::new(db, &sources)) {
        Ok(Bound::Expression(e)) => Some(e),
        _ => None,
    }
}

/// Random text made of what expressions are made of, with rubbish between.
fn rubbish() -> impl Strategy<Value = String> {
    let names: Vec<String> = flexure_expressions::functions().map(|f| f.name.to_string()).collect();
    let piece = prop_oneof![
        prop::sample::select(names),
        prop::sample::select(
            [
                "(",
                ")",
                "{",
                "}",
                "[",
                "]",
                ",",
                ".",
                ":",
                "?",
                "\"",
                "'",
                "!",
                "//",
                "**",
                "-",
                "1",
                "2.5e3",
                "1e400",
                " ",
                "d",
                "mm",
                ".m.p1.m1",
                "\"x\"",
                "\"%9999s\"",
                "\u{e4}",
                "\0",
                "eval",
                "none",
                "{1,2,3}",
                "{[1,2],[3,4]}",
                "-1",
                "0",
                "10000000",
                "\"*a*b*c\"",
                "self"
            ]
            .map(str::to_string)
            .to_vec()
        ),
    ];
    prop::collection::vec(piece, 0..14).prop_map(|p| p.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// What is printed reads back as the same tree, and prints the same again.
    #[test]
    fn printing_and_reading_give_the_expression_back(text in expressions()) {
        let db = fixture().db;
        if let Some(first) = as_bound(&db, &text) {
            let printed = print(&first, &db);
            let second = as_bound(&db, &printed);
            prop_assert_eq!(Some(&first), second.as_ref(), "{} printed as {}", text, printed);
            prop_assert_eq!(second.map(|e| print(&e, &db)), Some(printed));
        }
    }

    /// The shortest text of a number reads back as that number.
    #[test]
    fn numbers_read_back(x in prop::num::f64::NORMAL | prop::num::f64::ZERO) {
        let text = number_text(x.abs());
        prop_assert_eq!(text.parse::<f64>(), Ok(x.abs()));
        prop_assert!(text.contains('.'), "{}", text);
    }

    /// No text makes the parser, the binder or any function panic or run on.
    #[test]
    fn hostile_text_gives_a_value_or_an_error(text in rubbish()) {
        let db = fixture().db;
        if let Some(e) = as_bound(&db, &text) {
            let sources = Sources::default();
            let _ = evaluate(&e, &flexure_expressions::Scope::new(&db, &sources));
            let _ = print(&e, &db);
        }
    }

    /// Every function survives every kind of argument.
    #[test]
    fn functions_survive_any_arguments(
        which in 0_usize..1000,
        given in prop::collection::vec(prop::sample::select(vec![
            "1", "0", "-3", "2.5", "1e300", "-1e300", "1e-300", "{}", "{1,2,3}", "{3,1,2,5}", "{[1,2],[3,4]}", "{[1,2,3,4],[0,2,1,3]}",
            "{[0,0],[0,0]}", "\"\"", "\"x\"", "\"xz\"", "\"z_zx\"", "\"a\"", "\"body313\"", "\"%s%d\"", "{\"a\",\"b\"}", ".m.p1.m1", ".m", "{.m.p1,.m.p2}",
            "(none)", "\"marker\"", "\".m.p1.m1.location\"", "\"all\"", "1000000", "{{7,5,0},{15,11,0}}", "{[1,2,0],[2,1,-1],[3,1,1]}",
        ]), 0..6),
    ) {
        let db = fixture().db;
        let all: Vec<_> = flexure_expressions::functions().collect();
        let f = all[which % all.len()];
        let count = f.least.max(given.len().min(f.most));
        let arguments: Vec<&str> = (0..count).map(|i| *given.get(i % given.len().max(1)).unwrap_or(&"1")).collect();
        let text = format!("{}({})", f.name, arguments.join(","));
        if let Some(e) = as_bound(&db, &text) {
            let sources = Sources::default();
            let _ = evaluate(&e, &flexure_expressions::Scope::new(&db, &sources));
        }
    }

    /// Variables that depend on earlier ones in any pattern, changed in any order, hold what
    /// evaluation from scratch gives. Twin: the sums computed by plain arithmetic.
    #[test]
    fn chains_of_variables_follow_every_change(
        parents in prop::collection::vec(prop::collection::vec(0_usize..12, 0..4), 12),
        changes in prop::collection::vec((0_usize..12, -50_i32..50), 1..8),
    ) {
        let mut db = fixture().db;
        let ids: Vec<_> = (0..12)
            .map(|i| variable(&mut db, &format!("v{i}"), "real_value", Value::Number(f64::from(i))))
            .collect();
        // v(i) = sum of (position + 1) * v(parent) over parents below i; roots keep numbers.
        let below: Vec<Vec<usize>> = parents.iter().enumerate().map(|(i, p)| p.iter().copied().filter(|p| *p < i).collect()).collect();
        for (i, list) in below.iter().enumerate().rev() {
            if !list.is_empty() {
                let text = list.iter().enumerate().map(|(k, p)| format!("{} * v{p}", k + 1)).collect::<Vec<_>>().join(" + ");
                set(&mut db, ids[i], "real_value", &text).unwrap();
            }
        }
        let mut roots: Vec<f64> = (0..12).map(f64::from).collect();
        for (which, x) in changes {
            if !below[which].is_empty() {
                continue;
            }
            roots[which] = f64::from(x);
            db.set_value(ids[which], "real_value", Value::Number(f64::from(x)));
            let changed = key(&db, ids[which], "real_value");
            recompute(&mut db, &[changed]).unwrap();
            let mut expected = roots.clone();
            for (i, list) in below.iter().enumerate() {
                if !list.is_empty() {
                    expected[i] = list.iter().enumerate().map(|(k, p)| (k + 1) as f64 * expected[*p]).sum();
                }
            }
            for (id, x) in ids.iter().zip(&expected) {
                prop_assert_eq!(db.number(*id, "real_value"), Some(*x));
            }
        }
        // Closing the chain is refused, with the names of the circle.
        if let Some(i) = (0..12).find(|i| !below[*i].is_empty()) {
            let first = below[i][0];
            let error = set(&mut db, ids[first], "real_value", &format!("v{i} + 1")).unwrap_err();
            prop_assert_eq!(error.code, "expression/circle");
            prop_assert!(error.message.contains(&format!(".m.v{i}.")) && error.message.contains(&format!(".m.v{first}.")), "{}", error.message);
        }
    }
}

/// A count of children follows creation, renaming and deletion; what depends on it follows too. A
/// cell whose object is gone keeps its value and says so once.
#[test]
fn questions_to_the_database_are_asked_again() {
    let mut f = fixture();
    let count = variable(&mut f.db, "count", "real_value", Value::Number(0.0));
    let twice = variable(&mut f.db, "twice", "real_value", Value::Number(0.0));
    let named = variable(&mut f.db, "named", "string_value", Value::Text(String::new()));
    let beam_name = variable(&mut f.db, "beam_name", "string_value", Value::Text(String::new()));
    set(&mut f.db, count, "real_value", "DB_OBJECT_COUNT(DB_CHILDREN(.m, \"marker\"))").unwrap();
    set(&mut f.db, twice, "real_value", "2 * count").unwrap();
    set(&mut f.db, named, "string_value", ".m.p1.name // \"!\"").unwrap();
    set(&mut f.db, beam_name, "string_value", ".m.b.name").unwrap();
    assert_eq!(f.db.number(twice, "real_value"), Some(6.0)); // ref, m1, cm
    let made = f.db.create(&MARKER, Some(f.p1), "m2").unwrap();
    assert!(restructure(&mut f.db).unwrap().is_empty());
    assert_eq!(f.db.number(count, "real_value"), Some(4.0));
    assert_eq!(f.db.number(twice, "real_value"), Some(8.0));
    f.db.remove(made);
    f.db.rename(f.p1, Some(f.m), "arm").unwrap();
    assert!(restructure(&mut f.db).unwrap().is_empty());
    assert_eq!(f.db.number(twice, "real_value"), Some(6.0));
    assert_eq!(f.db.text(named, "string_value"), Some("arm!"));
    f.db.remove(f.beam);
    let warnings = restructure(&mut f.db).unwrap();
    assert_eq!(warnings.len(), 1);
    assert_eq!(warnings[0].code, "expression/no-longer-valid");
    assert!(warnings[0].message.contains(".m.beam_name."), "{}", warnings[0].message);
    assert_eq!(f.db.text(beam_name, "string_value"), Some("b"));
    assert!(restructure(&mut f.db).unwrap().is_empty());
}
