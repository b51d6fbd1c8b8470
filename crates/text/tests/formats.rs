//! The forms for programs against what their readers demand, on any diagnostics.

use flexure_text::{Diagnostic, FileId, Format, Severity, Sources, Span, render};
use proptest::prelude::*;
use serde_json::Value;

/// Files with odd names and texts, and diagnostics anywhere in them.
fn diagnostics() -> impl Strategy<Value = (Sources, Vec<Diagnostic>)> {
    let text = "[ -~é€\n\t\u{1}\u{fffe}]{0,40}";
    let file = ("[ -~é]{1,20}", text);
    let one = (0..3_u8, any::<prop::sample::Index>(), any::<prop::sample::Index>(), text, any::<bool>(), any::<bool>());
    (prop::collection::vec(file, 1..3), prop::collection::vec(one, 0..5)).prop_map(|(files, all)| {
        let mut sources = Sources::default();
        let ids: Vec<FileId> = files.into_iter().map(|(name, text)| sources.add(name, text)).collect();
        let found = all.into_iter().map(|(severity, from, to, message, placed, fixed)| {
            let severity = [Severity::Error, Severity::Warning, Severity::Note][usize::from(severity)];
            let file = ids[from.index(ids.len())];
            let text = sources.text(file);
            let boundary = |at: usize| (0..=at).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0);
            let (a, b) = (boundary(from.index(text.len() + 1)), boundary(to.index(text.len() + 1)));
            let span = Span::new(file, a.min(b), a.max(b));
            let mut diagnostic = Diagnostic::new(severity, "room/kind", message.clone()).note(message.clone());
            if placed {
                diagnostic = diagnostic.at(span, message.clone()).label(span, "also");
            }
            if fixed { diagnostic.fix("mend", span, message) } else { diagnostic }
        });
        let found = found.collect();
        (sources, found)
    })
}

fn text_of<'a>(value: &'a Value, path: &str) -> &'a str {
    value.pointer(path).and_then(Value::as_str).unwrap_or_else(|| panic!("{path} is missing in {value:#}"))
}

/// A reference as RFC 3986 has it: nothing but its characters, and `%` only before two digits.
fn is_uri_reference(text: &str) -> bool {
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"-._~:/?#[]@!$&'()*+,;=".contains(&b);
    let bytes = text.as_bytes();
    bytes.iter().enumerate().all(|(i, b)| {
        plain(*b) || *b == b'%' && bytes.get(i + 1..i + 3).is_some_and(|two| two.iter().all(u8::is_ascii_hexdigit))
    })
}

fn check_place(artifact: &Value, region: &Value) {
    assert!(is_uri_reference(text_of(artifact, "/uri")), "{artifact}");
    let number = |name: &str| region[name].as_u64().unwrap_or_else(|| panic!("{name} in {region}"));
    let (start, end) = ((number("startLine"), number("startColumn")), (number("endLine"), number("endColumn")));
    assert!(start.0 >= 1 && start.1 >= 1 && end >= start, "{region}");
}

/// Truth: what SARIF 2.1.0 (OASIS) requires: 3.13 log file, 3.14 run, 3.18 tool, 3.19 component,
/// 3.27 result, 3.29 physical location, 3.30 region, 3.55 fix, 3.56 change, 3.57 replacement.
fn check_sarif(text: &str, count: usize) {
    let log: Value = serde_json::from_str(text).unwrap();
    assert_eq!(text_of(&log, "/version"), "2.1.0");
    let runs = log["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 1);
    let run = &runs[0];
    assert_eq!(text_of(run, "/tool/driver/name"), "flexure");
    assert!(["utf16CodeUnits", "unicodeCodePoints"].contains(&text_of(run, "/columnKind")));
    let rules: Vec<&str> =
        run["tool"]["driver"]["rules"].as_array().unwrap().iter().map(|rule| text_of(rule, "/id")).collect();
    let mut unique = rules.clone();
    unique.dedup();
    assert_eq!(rules, unique);
    let results = run["results"].as_array().unwrap();
    assert_eq!(results.len(), count);
    for result in results {
        text_of(result, "/message/text");
        assert!(["none", "note", "warning", "error"].contains(&text_of(result, "/level")));
        assert!(rules.contains(&text_of(result, "/ruleId")));
        let places = |name: &str| result[name].as_array().unwrap().clone();
        for place in places("locations").iter().chain(&places("relatedLocations")) {
            let place = &place["physicalLocation"];
            check_place(&place["artifactLocation"], &place["region"]);
        }
        for fix in places("fixes") {
            text_of(&fix, "/description/text");
            for change in fix["artifactChanges"].as_array().unwrap() {
                for replacement in change["replacements"].as_array().unwrap() {
                    check_place(&change["artifactLocation"], &replacement["deletedRegion"]);
                    text_of(replacement, "/insertedContent/text");
                }
            }
        }
    }
}

/// Reads the whole document; counts cases and failures.
fn check_junit(text: &str, count: usize, failures: usize) {
    use quick_xml::events::Event;
    let mut reader = quick_xml::Reader::from_str(text);
    reader.config_mut().check_end_names = true;
    let (mut cases, mut failed, mut depth) = (0, 0, 0_i32);
    loop {
        match reader.read_event().unwrap() {
            Event::Start(start) => {
                depth += 1;
                for attribute in start.attributes() {
                    attribute.unwrap();
                }
                cases += usize::from(start.name().as_ref() == b"testcase");
                failed += usize::from(start.name().as_ref() == b"failure");
            }
            Event::Empty(start) => cases += usize::from(start.name().as_ref() == b"testcase"),
            Event::End(_) => depth -= 1,
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!((depth, cases, failed), (0, count.max(1), failures));
    // Truth: XML 1.0, production 2: the characters that a document may hold.
    let allowed =
        |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
    assert!(text.chars().all(allowed), "{text:?}");
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: prop::test_runner::RngSeed::Fixed(3), failure_persistence: None, ..ProptestConfig::with_cases(300)
    })]

    #[test]
    fn every_report_has_the_structure_its_readers_demand((sources, diagnostics) in diagnostics()) {
        let failures = diagnostics.iter().filter(|d| d.is_error()).count();
        check_sarif(&render(&sources, &diagnostics, Format::Sarif), diagnostics.len());
        check_junit(&render(&sources, &diagnostics, Format::Junit), diagnostics.len(), failures);
        let json: Value = serde_json::from_str(&render(&sources, &diagnostics, Format::Json)).unwrap();
        prop_assert!(json.is_object() || json.is_array());
        // One annotation is one line.
        let github = render(&sources, &diagnostics, Format::Github);
        prop_assert_eq!(github.lines().count(), diagnostics.len());
        prop_assert!(github.lines().all(|line| line.starts_with("::")));
    }
}
