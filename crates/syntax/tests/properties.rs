//! What holds for every input: no panic, spans on character boundaries, layout without meaning.

mod common;

use std::fmt::Write;

use flexure_syntax::command::{
    Expression, ExpressionKind, ItemKind, Statement, StatementKind, comments, parse, parse_expression,
};
use flexure_syntax::function;
use proptest::prelude::*;
use text::{FileId, Span};

/// Pieces that mean something to the lexer, so that random texts reach deep into it.
fn hostile_text() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        prop::sample::select(vec![
            "a", "name", ".m.p", "1", "2.5e3", "1e400", "d", " ", "\t", "\n", "\r\n", "&", "& \n", "!", "=", ",", "(",
            ")", "{", "}", "[", "]", "\"", "'", "\\", "\\\"", "**", "*", "//", "/", "+", "-", "?", ":", "<", "==",
            "!=", "&&", "||", "é", "\u{feff}", "\u{0}", "$", ".", "eval(", "IF(", "%", "\u{a0}", "€",
        ])
        .prop_map(str::to_owned),
        any::<char>().prop_map(String::from),
    ];
    prop::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat())
}

fn all_spans(statements: &[Statement]) -> Vec<Span> {
    let mut spans = Vec::new();
    for statement in statements {
        spans.push(statement.span);
        let items = match &statement.kind {
            StatementKind::Command { keywords, arguments } => {
                spans.extend(keywords);
                for argument in arguments {
                    spans.extend([argument.name, argument.value_span]);
                }
                arguments.iter().flat_map(|a| &a.values).collect::<Vec<_>>()
            }
            StatementKind::Assignment { target, values } => {
                spans.push(*target);
                values.iter().collect()
            }
            StatementKind::Broken => Vec::new(),
        };
        for item in items {
            spans.push(item.span);
            if let ItemKind::Expression(tree) = &item.kind {
                expression_spans(tree, &mut spans);
            }
        }
    }
    spans
}

fn expression_spans(tree: &Expression, spans: &mut Vec<Span>) {
    spans.push(tree.span);
    let below: Vec<&Expression> = match &tree.kind {
        ExpressionKind::Call { arguments, function_span, .. } => {
            spans.push(*function_span);
            arguments.iter().collect()
        }
        ExpressionKind::Index(inner, indices) => std::iter::once(&**inner).chain(indices).collect(),
        ExpressionKind::Attribute(inner, _) | ExpressionKind::Unary(_, inner) => vec![inner],
        ExpressionKind::Binary(_, a, b) => vec![a, b],
        ExpressionKind::Conditional(c, a, b) => vec![c, a, b],
        ExpressionKind::Array(all) | ExpressionKind::Row(all) | ExpressionKind::Tuple(all) => all.iter().collect(),
        _ => Vec::new(),
    };
    for tree in below {
        expression_spans(tree, spans);
    }
}

/// A value with the tree it stands for.
fn value() -> impl Strategy<Value = (String, String)> {
    prop_oneof![
        (-1e9..1e9_f64).prop_map(|x| (format!("{x:?}"), format!("{x:?}"))),
        any::<i32>().prop_map(|i| (i.to_string(), format!("{:?}", f64::from(i)))),
        (0..100_u8).prop_map(|i| (format!("{i}mm"), format!("{:?}<mm>", f64::from(i)))),
        "[a-c.]{0,3}\\.[a-z_]{1,8}".prop_map(|name| (name.clone(), name)),
        "[ -~]{0,12}".prop_map(|text| {
            let quoted = format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""));
            (quoted, format!("{text:?}"))
        }),
        (0..9_u8, 0..9_u8).prop_map(|(a, b)| (format!("({a} *{b})"), format!("((* {a}.0 {b}.0))"))),
    ]
}

/// What may stand between two tokens without changing the meaning.
fn gap() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        " ",
        "  ",
        "\t",
        "&\n",
        " & \r\n ",
        "& ! note\n",
        " &\n! note &\n  ",
        "&\n&\n",
        " &\n  ! x = \"y\n\t",
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn no_input_panics_and_every_span_can_be_sliced(text in hostile_text()) {
        let (statements, diagnostics) = parse(FileId(0), &text);
        for span in all_spans(&statements) {
            prop_assert!(text.get(span.range()).is_some(), "{span:?}");
        }
        for label in diagnostics.iter().flat_map(|d| d.primary.iter().chain(&d.secondary)) {
            prop_assert!(text.get(label.span.range()).is_some(), "{label:?}");
        }
        for comment in comments(FileId(0), &text) {
            prop_assert!(text.get(comment.span.range()).is_some_and(|c| c.starts_with('!')));
        }
        let (_, diagnostics) = parse_expression(FileId(0), &text, 0);
        prop_assert!(diagnostics.iter().all(|d| text.get(d.primary.as_ref().unwrap().span.range()).is_some()));
        let (_, diagnostics) = function::parse(FileId(0), &text, 0);
        prop_assert!(diagnostics.iter().all(|d| text.get(d.primary.as_ref().unwrap().span.range()).is_some()));
    }

    /// Nothing is swallowed: statements come in order, and between them stand only blanks,
    /// comments and marks.
    #[test]
    fn statements_do_not_overlap_and_lose_no_text(text in hostile_text()) {
        let (statements, diagnostics) = parse(FileId(0), &text);
        let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
        for range in statements.iter().map(|s| s.span.range()).chain(std::iter::once(text.len()..text.len())) {
            prop_assert!(range.start >= at);
            let lossless = if diagnostics.is_empty() { &text[at..range.start] } else { "" };
            for line in lossless.lines() {
                let line = line.trim();
                let rest = line.trim_start_matches(['&', ' ', '\t', '\r', '\u{b}', '\u{c}']);
                prop_assert!(rest.is_empty() || rest.starts_with('!'), "{line:?} was lost");
            }
            at = range.end;
        }
    }

    #[test]
    fn layout_does_not_change_a_command(
        values in prop::collection::vec((value(), gap(), gap(), gap()), 1..8),
        first in gap(),
    ) {
        let mut text = format!("force{first}create");
        let mut expected = "force create".to_owned();
        for (i, ((typed, meant), a, b, c)) in values.iter().enumerate() {
            write!(text, "{a}p{i}{b}={c}{typed}{b},{a}{typed}").unwrap();
            write!(expected, " | p{i} = {meant}, {meant}").unwrap();
        }
        prop_assert_eq!(common::shape(&text), expected);
    }

    #[test]
    fn any_bytes_can_be_read(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let mut sources = text::Sources::default();
        let file = sources.add_bytes("x.cmd", bytes);
        let (_, diagnostics) = parse(file, sources.text(file));
        let rendered = text::render(&sources, &diagnostics, text::Format::Terminal { colours: false });
        prop_assert_eq!(rendered.is_empty(), diagnostics.is_empty());
    }

    /// Twin: the same arithmetic done by Rust.
    #[test]
    fn functions_are_read_as_arithmetic(a in 1..9_i32, b in 1..9_i32, c in 1..3_i32) {
        let (x, y) = (f64::from(a), f64::from(b));
        let text = format!("-{a}**{c} + {b} * ( {a} - {b} ) / -{a}");
        let expected = -x.powi(c) + y * (x - y) / -x;
        let (tree, _) = function::parse(FileId(0), &text, 0);
        prop_assert!((evaluate(&tree) - expected).abs() < 1e-9); // rounding of a few operations on small integers
    }
}

fn evaluate(tree: &function::FunctionExpression) -> f64 {
    use function::{FunctionKind as K, FunctionOperator as O};
    match &tree.kind {
        K::Number(x) => *x,
        K::Negate(x) => -evaluate(x),
        K::Binary(operator, a, b) => match (operator, evaluate(a), evaluate(b)) {
            (O::Add, a, b) => a + b,
            (O::Subtract, a, b) => a - b,
            (O::Multiply, a, b) => a * b,
            (O::Divide, a, b) => a / b,
            (O::Power, a, b) => a.powf(b),
        },
        _ => f64::NAN,
    }
}

/// Time grows with the length of the text and not with its square.
#[test]
fn hostile_repetition_is_read_in_linear_time() {
    for piece in
        ["\"", "{ ", "{a", "( ", "a=\"", "& ", "'", "a=1(", "[", "\"\n", "a=\"\n\\\"", "=", ", ", "1(1", "a(", "$'"]
    {
        let text = piece.repeat(1_000_000 / piece.len());
        let start = std::time::Instant::now();
        let _ = parse(FileId(0), &text);
        let _ = comments(FileId(0), &text).count();
        let _ = parse_expression(FileId(0), &text, 0);
        let _ = function::parse(FileId(0), &text, 0);
        // Quadratic work on a megabyte takes minutes; linear work some milliseconds.
        assert!(start.elapsed().as_secs() < 10, "{piece:?} takes {:?}", start.elapsed());
    }
}
