//! Every exported command file of the shared corpus is read to its end, and each command is either
//! executed or named. Skipped, with a printed line, where the corpus is not at hand.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use flexure_commands::{Interpreter, OnError};

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd") {
            found.push(path);
        }
    }
}

#[test]
fn every_exported_model_is_read_to_its_end() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let mut found = Vec::new();
    files(&Path::new(&shared).join("corpus"), &mut found);
    let mut unexplained = 0;
    for path in found {
        let started = std::time::Instant::now();
        let mut interpreter = Interpreter::new(elements::registry());
        interpreter.on_error = OnError::IgnoreCommand;
        let report = interpreter.run_file(&path);
        println!(
            "{}: {} executed, {} skipped, {} failed in {:?}",
            path.display(),
            report.executed,
            report.skipped,
            report.failed,
            started.elapsed()
        );
        assert!(!report.aborted, "{} was not read to its end", path.display());
        let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
        for diagnostic in &report.diagnostics {
            *kinds
                .entry(format!("{} {}", diagnostic.code, if diagnostic.is_error() { "ERROR" } else { "" }))
                .or_default() += 1;
        }
        println!("   {kinds:?}");
        let mut shown = 0;
        for diagnostic in report.diagnostics.iter().filter(|d| d.is_error()) {
            unexplained += 1;
            shown += 1;
            if shown <= 12 {
                let place =
                    diagnostic.primary.as_ref().map(|l| interpreter.sources.line_column(l.span.file, l.span.start));
                println!("   {}:{:?} {}", diagnostic.code, place.map(|p| p.line), diagnostic.message);
            }
        }
        let mut skipped: BTreeMap<&str, usize> = BTreeMap::new();
        for d in report.diagnostics.iter().filter(|d| d.code == "command/not-supported") {
            *skipped.entry(&d.message).or_default() += 1;
        }
        println!("   {skipped:?}");
    }
    println!("{unexplained} errors");
}
