//! The forms for programs: JSON, GitHub annotations, SARIF, JUnit.

use quick_xml::escape::escape;
use serde_json::{Value, json};

use super::{one_line, printable, range};
use crate::{Diagnostic, Label, Severity, Sources, Span};

pub(super) fn json(sources: &Sources, diagnostics: &[Diagnostic]) -> String {
    let all: Vec<Value> = diagnostics
        .iter()
        .map(|d| {
            json!({
                "severity": d.severity.word(),
                "code": d.code,
                "message": d.message,
                "primary": d.primary.as_ref().map(|label| json_label(sources, label)),
                "secondary": d.secondary.iter().map(|label| json_label(sources, label)).collect::<Vec<_>>(),
                "notes": d.notes,
                "helps": d.helps.iter().map(|help| json!({
                    "text": help.text,
                    "fix": help.fix.as_ref().map(|fix| json!({
                        "place": json_place(sources, fix.span),
                        "replacement": fix.replacement,
                    })),
                })).collect::<Vec<_>>(),
            })
        })
        .collect();
    let count = |severity| diagnostics.iter().filter(|d| d.severity == severity).count();
    pretty(&json!({
        "diagnostics": all,
        "errors": count(Severity::Error),
        "warnings": count(Severity::Warning),
        "notes": count(Severity::Note),
    }))
}

fn pretty(value: &Value) -> String {
    format!("{value:#}\n")
}

fn json_label(sources: &Sources, label: &Label) -> Value {
    json!({ "place": json_place(sources, label.span), "text": label.text })
}

fn json_place(sources: &Sources, span: Span) -> Value {
    let (start, end) = range(sources, span);
    json!({
        "file": sources.name(span.file),
        "line": start.line,
        "column": start.column,
        "end_line": end.line,
        "end_column": end.column,
        "start_byte": span.start,
        "end_byte": span.end,
    })
}

/// Notes and helps below each other.
fn details(d: &Diagnostic) -> String {
    let label = d.primary.iter().filter(|l| !l.text.is_empty()).map(|l| l.text.clone());
    let notes = d.notes.iter().map(|note| format!("note: {note}"));
    let helps = d.helps.iter().map(|help| format!("help: {}", help.text));
    label.chain(notes).chain(helps).collect::<Vec<_>>().join("\n")
}

pub(super) fn github(sources: &Sources, diagnostics: &[Diagnostic]) -> String {
    let data = |text: &str| text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A");
    let property = |text: &str| data(text).replace(':', "%3A").replace(',', "%2C");
    let mut out = String::new();
    for d in diagnostics {
        let kind = match d.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "notice",
        };
        let mut properties = Vec::new();
        if let Some(label) = &d.primary {
            let (start, end) = range(sources, label.span);
            properties.push(format!("file={}", property(sources.name(label.span.file))));
            properties.push(format!("line={},endLine={}", start.line, end.line));
            if start.line == end.line {
                properties.push(format!("col={},endColumn={}", start.column, end.column));
            } else {
                properties.push(format!("col={}", start.column));
            }
        }
        properties.push(format!("title={}", property(d.code)));
        let details = details(d);
        let separator = if details.is_empty() { "" } else { "\n" };
        let text = data(&format!("{}{separator}{details}", printable(&d.message)));
        out.extend(["::", kind, " ", &properties.join(","), "::", &text, "\n"]);
    }
    out
}

pub(super) fn sarif(sources: &Sources, diagnostics: &[Diagnostic]) -> String {
    let mut codes: Vec<&str> = diagnostics.iter().map(|d| d.code).collect();
    codes.sort_unstable();
    codes.dedup();
    let rules: Vec<Value> = codes.iter().map(|code| json!({ "id": code })).collect();
    let region = |span: Span| {
        let (start, end) = range(sources, span);
        json!({
            "startLine": start.line, "startColumn": start.column,
            "endLine": end.line, "endColumn": end.column,
        })
    };
    let artifact = |span: Span| json!({ "uri": uri(sources.name(span.file)) });
    let location =
        |span: Span| json!({ "physicalLocation": { "artifactLocation": artifact(span), "region": region(span) } });
    let fixes = |d: &Diagnostic| -> Vec<Value> {
        let fixes = d.helps.iter().filter_map(|help| Some((help, help.fix.as_ref()?)));
        fixes
            .map(|(help, fix)| {
                json!({
                    "description": { "text": help.text },
                    "artifactChanges": [{
                        "artifactLocation": artifact(fix.span),
                        "replacements": [{
                            "deletedRegion": region(fix.span),
                            "insertedContent": { "text": fix.replacement },
                        }],
                    }],
                })
            })
            .collect()
    };
    let results: Vec<Value> = diagnostics
        .iter()
        .map(|d| {
            let details = details(d);
            let separator = if details.is_empty() { "" } else { "\n" };
            json!({
                "ruleId": d.code,
                "level": d.severity.word(),
                "message": { "text": format!("{}{separator}{details}", d.message) },
                "locations": d.primary.iter().map(|label| location(label.span)).collect::<Vec<_>>(),
                "relatedLocations": d.secondary.iter().map(|label| {
                    let mut place = location(label.span);
                    place["message"] = json!({ "text": label.text });
                    place
                }).collect::<Vec<_>>(),
                "fixes": fixes(d),
            })
        })
        .collect();
    let driver = json!({ "name": "flexure", "version": env!("CARGO_PKG_VERSION"), "rules": rules });
    pretty(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{ "tool": { "driver": driver }, "columnKind": "unicodeCodePoints", "results": results }],
    }))
}

/// A file's name as a reference that a URI may be: what has no place in one is written `%20`.
fn uri(name: &str) -> String {
    let mut out = String::new();
    for byte in name.replace('\\', "/").bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            let digit = |n: u8| char::from(b"0123456789ABCDEF"[usize::from(n)]);
            out.extend(['%', digit(byte >> 4), digit(byte & 15)]);
        }
    }
    out
}

pub(super) fn junit(sources: &Sources, diagnostics: &[Diagnostic]) -> String {
    let failures = diagnostics.iter().filter(|d| d.is_error()).count();
    let tests = diagnostics.len().max(1); // a suite without cases counts as broken in many readers
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{tests}\" failures=\"{failures}\">\n  \
         <testsuite name=\"flexure\" tests=\"{tests}\" failures=\"{failures}\">\n"
    );
    if diagnostics.is_empty() {
        out += "    <testcase classname=\"flexure\" name=\"no findings\"/>\n";
    }
    for d in diagnostics {
        let file = d.primary.as_ref().map_or("flexure", |label| sources.name(label.span.file));
        let line = one_line(sources, d);
        let element = if d.is_error() {
            format!("<failure type=\"{}\" message=\"{}\">", escape(d.code), escape(xml_text(&d.message)))
        } else {
            "<system-out>".to_owned()
        };
        let close = if d.is_error() { "</failure>" } else { "</system-out>" };
        let case = format!(
            "    <testcase classname=\"{}\" name=\"{}\">\n      {element}{}{close}\n    </testcase>\n",
            escape(xml_text(file)),
            escape(xml_text(&line)),
            escape(xml_text(&format!("{line}\n{}", details(d)))),
        );
        out.push_str(&case);
    }
    out + "  </testsuite>\n</testsuites>\n"
}

/// XML has no way to write most control characters.
fn xml_text(text: &str) -> String {
    text.chars()
        .map(|c| {
            if c.is_control() && !matches!(c, '\n' | '\t') || matches!(c, '\u{fffe}' | '\u{ffff}') {
                '\u{fffd}'
            } else {
                c
            }
        })
        .collect()
}
