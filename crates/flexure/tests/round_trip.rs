//! `.cmd` -> model -> `.cmd` -> model is the identity, on our examples and on every model that Adams
//! exported, where those are at hand (environment variable `FLEXURE_SHARED`).

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use flexure::Session;
use syntax::command::{Item, ItemKind, StatementKind};
use text::Sources;

fn command_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            command_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd") {
            found.push(path);
        }
    }
}

/// Reads a file, and says what of it was refused.
fn read(path: &Path) -> (Session, Vec<String>) {
    let mut session = Session::new();
    session.touch_nothing(true);
    let report = session.read(path);
    let errors = report.diagnostics.iter().filter(|d| d.is_error());
    let errors = errors.map(|d| text::one_line(session.sources(), d)).collect();
    (session, errors)
}

fn written(session: &mut Session, path: &Path) -> String {
    session.write(path).unwrap();
    std::fs::read_to_string(path).unwrap()
}

/// Reads, writes, reads and writes: both models are equal, and both texts to the byte. Returns the
/// text, or none for a file without a model.
fn round_trip(path: &Path) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let (first_file, second_file) = (folder.path().join("first.cmd"), folder.path().join("second.cmd"));
    let (mut first, refused) = read(path);
    for line in refused {
        println!("refused: {line}"); // that files of Adams are read without errors is tested elsewhere
    }
    first.model()?;
    let text = written(&mut first, &first_file);
    let (mut second, refused) = read(&first_file);
    assert!(refused.is_empty(), "{}: {refused:#?}", path.display());
    let differences = first.compare(&second, 0.0).unwrap();
    assert!(differences.is_empty(), "{}: {:#?}", path.display(), differences.changes);
    let again = written(&mut second, &second_file);
    for (number, (a, b)) in text.lines().zip(again.lines()).enumerate() {
        assert_eq!(a, b, "line {} of the export of {}", number + 1, path.display());
    }
    assert_eq!(text, again, "{}", path.display());
    Some(text)
}

#[test]
fn examples_survive_the_round_trip() {
    let mut found = Vec::new();
    command_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples"), &mut found);
    assert_eq!(found.iter().filter_map(|path| round_trip(path)).count(), 5);
}

/// A statement without its layout: words, then parameters by name, numbers by value.
fn statements(text: &str) -> BTreeMap<String, usize> {
    let mut sources = Sources::default();
    let file = sources.add("", text);
    let text = sources.text(file);
    let mut found = BTreeMap::new();
    for statement in syntax::command::parse(file, text).0 {
        let StatementKind::Command { keywords, arguments } = &statement.kind else { continue };
        let words: Vec<String> = keywords.iter().map(|k| text[k.range()].to_lowercase()).collect();
        let mut named: Vec<String> = arguments
            .iter()
            .map(|a| format!("{} = {}", text[a.name.range()].to_lowercase(), values(text, &a.values)))
            .collect();
        named.sort();
        *found.entry(format!("{} {}", words.join(" "), named.join("; "))).or_default() += 1;
    }
    found
}

fn values(text: &str, items: &[Item]) -> String {
    let mut out = String::new();
    for item in items {
        match &item.kind {
            // Adams writes ten to thirteen digits.
            ItemKind::Number { value, unit } => {
                write!(out, "{:.9e}{} ", value + 0.0, unit.as_deref().unwrap_or("")).unwrap();
            }
            _ => write!(out, "{} ", text[item.span.range()].split_whitespace().collect::<Vec<_>>().join(" ")).unwrap(),
        }
    }
    out
}

/// Truth: Adams' own text of the model. How much of it Flexure writes in the same words is printed,
/// with what differs by kind of command, and may not become less.
#[test]
fn exports_of_adams_survive_the_round_trip() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let mut found = Vec::new();
    command_files(&Path::new(&shared).join("corpus"), &mut found);
    let (mut models, mut all, mut equal) = (0, 0, 0);
    for path in found {
        let bytes = std::fs::read(&path).unwrap();
        let mut sources = Sources::default();
        let file = sources.add_bytes("", bytes);
        let original = sources.text(file).to_owned();
        let Some(text) = round_trip(&path) else {
            println!("no model in {}", path.display());
            continue;
        };
        models += 1;
        let mut ours = statements(&text);
        let mut missing: BTreeMap<String, (usize, String)> = BTreeMap::new();
        let (mut here, mut same) = (0, 0);
        for (statement, times) in statements(&original) {
            here += times;
            let matched = ours.get_mut(&statement).map_or(0, |left| {
                let matched = times.min(*left);
                *left -= matched;
                matched
            });
            same += matched;
            if matched < times {
                let words: Vec<&str> = statement.split(' ').take_while(|w| !w.contains('=')).collect();
                let kind = words[..words.len().saturating_sub(1).max(1)].join(" ");
                let entry = missing.entry(kind).or_insert_with(|| (0, statement.clone()));
                entry.0 += times - matched;
            }
        }
        println!("{}: {same} of {here} statements are written as Adams wrote them", path.display());
        for (kind, (times, example)) in missing {
            println!("   {times} x {kind}   e.g. {}", example.chars().take(300).collect::<String>());
        }
        all += here;
        equal += same;
    }
    println!("{models} models, {equal} of {all} statements");
    assert_eq!(models, 11);
    // Memory: less than this would be a step back.
    assert!(equal >= 9_470, "{equal}");
}
