//! Every format on the same few diagnostics, as snapshots, and every format on awkward ones.

use flexure_text::{Diagnostic, FileId, Format, Severity, Sources, Span, one_line, render};
use proptest::prelude::*;

const CAR: &str = "force create element_like beam  &\n   beam_name = .car.bar  &\n   i_marker_name = .car.arm.end  &\n   \
                   i_part_name = .car.arm  &\n   yongs_modulus = 2.07E+05  &\r\n   länge = \"é\"\n";

fn span_of(sources: &Sources, file: FileId, needle: &str) -> Span {
    let start = sources.text(file).find(needle).unwrap();
    Span::new(file, start, start + needle.len())
}

fn examples() -> (Sources, Vec<Diagnostic>) {
    let mut sources = Sources::default();
    let file = sources.add("car.cmd", CAR);
    let unknown = span_of(&sources, file, "yongs_modulus");
    let part = span_of(&sources, file, "i_part_name");
    let marker = span_of(&sources, file, "i_marker_name");
    let accent = span_of(&sources, file, "\"é\"");
    let diagnostics = vec![
        Diagnostic::error(
            "command/unknown-argument",
            "`force create element_like beam` has no argument `yongs_modulus`",
        )
        .at(unknown, "not an argument of this command")
        .fix("did you mean `youngs_modulus`?", unknown, "youngs_modulus"),
        Diagnostic::error(
            "command/conflicting-arguments",
            "a beam is placed by two markers or by two parts, not by both",
        )
        .at(part, "this chooses parts")
        .label(marker, "this chooses markers")
        .help("remove `i_part_name`; the marker already belongs to `.car.arm`"),
        Diagnostic::warning("beam/preloaded", "100 % of <bar> & more").at(accent, "here").note("a note"),
        Diagnostic::new(Severity::Note, "run/end", "the run ended at t = 2.0 s"),
    ];
    (sources, diagnostics)
}

#[test]
fn terminal() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(render(&sources, &diagnostics, Format::Terminal { colours: false }));
}

#[test]
fn one_line_each() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(render(&sources, &diagnostics, Format::OneLine));
}

#[test]
fn json() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(render(&sources, &diagnostics, Format::Json));
}

#[test]
fn github() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(render(&sources, &diagnostics, Format::Github));
}

#[test]
fn sarif() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(
        render(&sources, &diagnostics, Format::Sarif).replace(env!("CARGO_PKG_VERSION"), "VERSION")
    );
}

#[test]
fn junit() {
    let (sources, diagnostics) = examples();
    insta::assert_snapshot!(render(&sources, &diagnostics, Format::Junit));
}

#[test]
fn junit_without_findings_has_a_passed_case() {
    assert!(render(&Sources::default(), &[], Format::Junit).contains("tests=\"1\" failures=\"0\""));
}

#[test]
fn colours_are_escape_sequences_and_can_be_off() {
    let (sources, diagnostics) = examples();
    assert!(render(&sources, &diagnostics, Format::Terminal { colours: true }).contains('\u{1b}'));
    assert!(!render(&sources, &diagnostics, Format::Terminal { colours: false }).contains('\u{1b}'));
}

#[test]
fn a_message_cannot_send_commands_to_the_terminal() {
    let mut sources = Sources::default();
    let file = sources.add("a.cmd", "\u{1b}[31mred\n");
    let d = Diagnostic::error("a/b", "`\u{1b}[31mred` is odd").at(Span::new(file, 0, 8), "here");
    for format in [Format::Terminal { colours: false }, Format::OneLine, Format::Github, Format::Junit] {
        assert!(!render(&sources, std::slice::from_ref(&d), format).contains('\u{1b}'), "{format:?}");
    }
    assert!(one_line(&sources, &d).starts_with("a.cmd:1:1: error[a/b]: "));
}

#[test]
fn a_very_long_line_is_shown_around_the_place() {
    let mut sources = Sources::default();
    let file = sources.add("long.cmd", format!("{}wrong{}\n", "é".repeat(30_000), "b".repeat(60_000)));
    let d = Diagnostic::error("a/b", "long").at(Span::new(file, 60_000, 60_005), "here");
    let text = render(&sources, &[d], Format::Terminal { colours: false });
    assert!(text.contains("long.cmd:1:30001") && text.contains("wrong") && text.len() < 1000, "{text}");
}

proptest! {
    /// Wherever a span lies, rendering shows something and does not fail.
    #[test]
    fn any_place_in_any_text_is_rendered(text in "[a\u{e9}\t\r\n\"\u{0} ]{0,40}", a in 0_usize..50, b in 0_usize..50) {
        let mut sources = Sources::default();
        let file = sources.add("x.cmd", text.clone());
        let boundary = |i: usize| (0..=i.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0);
        let (a, b) = (boundary(a.min(b)), boundary(a.max(b)));
        let d = Diagnostic::error("a/b", "trouble").at(Span::new(file, a, b), "label").label(Span::new(file, 0, a), "");
        for format in [
            Format::Terminal { colours: false },
            Format::OneLine,
            Format::Json,
            Format::Github,
            Format::Sarif,
            Format::Junit,
        ] {
            let rendered = render(&sources, std::slice::from_ref(&d), format);
            prop_assert!(rendered.contains("trouble") && rendered.contains("x.cmd"));
        }
    }
}
