//! Real exports, where the folder with them exists (environment variable `FLEXURE_SHARED`).

mod common;

use std::path::{Path, PathBuf};

use flexure_syntax::command::{ItemKind, StatementKind, comments, parse};
use flexure_syntax::function;
use text::{Format, Sources, render};

fn command_files() -> Vec<PathBuf> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "cmd") {
                found.push(path);
            }
        }
    }
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return Vec::new();
    };
    let mut found = Vec::new();
    walk(&PathBuf::from(shared).join("corpus"), &mut found);
    assert!(!found.is_empty(), "the corpus has command files");
    found.sort();
    found
}

/// Twin: counts logical lines by joining what ends in `&`, with no grammar but the quotes that
/// exports leave open over several lines.
fn count_logical_lines(text: &str) -> usize {
    let (mut count, mut continued, mut open) = (0, false, false);
    for line in text.lines() {
        let line = line.trim();
        if !open && (line.is_empty() || line.starts_with('!')) {
            continued &= !line.is_empty();
            continue;
        }
        count += usize::from(!continued && !open);
        open ^= line.replace("\\\"", "").matches('"').count() % 2 == 1;
        continued = line.ends_with('&');
    }
    count
}

#[test]
fn every_export_is_read_to_its_end_without_trouble() {
    for path in command_files() {
        let mut sources = Sources::default();
        let file = sources.add_bytes(path.display().to_string(), std::fs::read(&path).unwrap());
        let text = sources.text(file);
        let (statements, diagnostics) = parse(file, text);
        assert!(diagnostics.is_empty(), "{}", render(&sources, &diagnostics, Format::Terminal { colours: false }));
        assert_eq!(statements.len(), count_logical_lines(text), "{}", path.display());
        let own_lines = comments(file, text).filter(|c| c.own_line).count();
        let expected = text.lines().filter(|l| l.trim_start().starts_with('!')).count();
        // Only the file with solver commands in a string of many lines has lines that look like comments.
        let in_string = if path.ends_with("test_analysis_1.cmd") { expected - own_lines } else { 0 };
        assert_eq!(own_lines + in_string, expected, "{}", path.display());
        println!("{}: {} statements", path.display(), statements.len());
    }
}

#[test]
fn every_run_time_function_of_the_exports_is_read() {
    let mut count = 0;
    for path in command_files() {
        let mut sources = Sources::default();
        let file = sources.add_bytes(path.display().to_string(), std::fs::read(&path).unwrap());
        let text = sources.text(file);
        for statement in parse(file, text).0 {
            let StatementKind::Command { arguments, .. } = &statement.kind else { continue };
            for argument in arguments {
                let name = &text[argument.name.range()];
                let is_function =
                    name == "function" || name.ends_with("_function") || (name.len() == 2 && name.starts_with('f'));
                let pieces = argument.values.iter().map(|v| match &v.kind {
                    ItemKind::Text(t) => Some(t.as_str()),
                    _ => None,
                });
                let Some(joined) = pieces.collect::<Option<String>>().filter(|t| is_function && !t.is_empty()) else {
                    continue;
                };
                let (_, diagnostics) = function::parse(file, &joined, 0);
                assert!(diagnostics.is_empty(), "{}: {name} = {joined}\n{diagnostics:#?}", path.display());
                count += 1;
            }
        }
    }
    println!("{count} functions");
}
