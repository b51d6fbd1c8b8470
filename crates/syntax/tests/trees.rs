//! The trees of every file in `test_data`, and its troubles as a user sees them, as snapshots.

mod common;

use std::path::PathBuf;

use flexure_syntax::command::parse;
use text::{Format, Sources, render};

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("test_data").join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()).collect();
    files.sort();
    files
}

fn trees_and_troubles(path: &PathBuf) -> (String, String) {
    let mut sources = Sources::default();
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let file = sources.add_bytes(name, std::fs::read(path).unwrap());
    let text = sources.text(file);
    let (statements, diagnostics) = parse(file, text);
    let trees: String = statements.iter().map(|s| common::statement(text, s).replace(" | ", "\n    ") + "\n").collect();
    (trees, render(&sources, &diagnostics, Format::Terminal { colours: false }))
}

#[test]
fn right_files_give_these_trees() {
    for path in files("command") {
        let (trees, troubles) = trees_and_troubles(&path);
        assert_eq!(troubles, "");
        insta::assert_snapshot!(path.file_stem().unwrap().to_string_lossy().into_owned(), trees);
    }
}

#[test]
fn wrong_files_give_these_troubles() {
    for path in files("broken") {
        let (trees, troubles) = trees_and_troubles(&path);
        let name = format!("broken_{}", path.file_stem().unwrap().to_string_lossy());
        insta::assert_snapshot!(name, format!("{troubles}\n----\n{trees}"));
    }
}

/// Half-typed input is normal: whatever of a file has been typed is parsed.
#[test]
fn every_prefix_of_every_file_is_parsed() {
    for path in files("command").into_iter().chain(files("broken")) {
        let text = std::fs::read_to_string(&path).unwrap();
        for (end, _) in text.char_indices() {
            let (statements, _) = parse(common::FILE, &text[..end]);
            assert!(statements.iter().all(|s| text.get(s.span.range()).is_some()));
        }
    }
}
