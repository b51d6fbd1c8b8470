//! Every exported command file of the shared corpus is read to its end, and each command is either
//! executed or named. Skipped, with a printed line, where the corpus is not at hand.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
};

use flexure_commands::{Interpreter, OnError, Report};

fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, ending, found);
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
}

/// All command files; none, with a printed line, where there is no corpus.
fn exports() -> Vec<PathBuf> {
    let mut found = Vec::new();
    match std::env::var_os("FLEXURE_SHARED") {
        Some(shared) => {
            files(&Path::new(&shared).join("corpus"), "cmd", &mut found);
            assert!(found.len() >= 11, "the corpus is not complete: {found:?}");
        }
        None => println!("skipped: FLEXURE_SHARED is not set"),
    }
    found
}

fn read(path: &Path) -> (Interpreter, Report) {
    let mut interpreter = Interpreter::new(elements::registry());
    interpreter.on_error = OnError::IgnoreCommand;
    let report = interpreter.run_file(path);
    (interpreter, report)
}

/// How often each path was skipped because it is not executed.
fn skipped(report: &Report) -> BTreeMap<&str, usize> {
    let mut skipped = BTreeMap::new();
    for warning in report.diagnostics.iter().filter(|d| d.code == "command/not-supported") {
        *skipped.entry(warning.message.split('`').nth(1).unwrap_or("")).or_default() += 1;
    }
    skipped
}

#[test]
fn every_command_of_every_export_is_executed_or_named() {
    for path in exports() {
        let (interpreter, report) = read(&path);
        println!("{}: {} executed, {} skipped", path.display(), report.executed, report.skipped);
        for (what, times) in skipped(&report) {
            println!("   {times} x {what}");
        }
        let errors: Vec<String> = report
            .diagnostics
            .iter()
            .filter(|d| d.is_error())
            .map(|d| {
                let place = d.primary.as_ref().map(|l| interpreter.sources.line_column(l.span.file, l.span.start).line);
                format!("line {place:?}: {}: {}", d.code, d.message)
            })
            .collect();
        assert!(errors.is_empty() && report.failed == 0 && !report.aborted, "{}: {errors:#?}", path.display());

        // Adams wrote these numbers: none is out of bounds.
        let outside = report.diagnostics.iter().find(|d| d.code == "value/outside-limit");
        assert!(outside.is_none(), "{}: {outside:#?}", path.display());

        // Each kind of skipped command has one warning, with the place of the first and how many there are.
        let warnings: Vec<_> = report
            .diagnostics
            .iter()
            .filter(|d| matches!(d.code, "command/not-supported" | "command/skipped-too"))
            .collect();
        let places: BTreeSet<_> =
            warnings.iter().filter_map(|d| d.primary.as_ref()).map(|l| (l.span.file, l.span.start)).collect();
        let more = warnings.iter().flat_map(|d| &d.notes).filter(|n| n.ends_with("commands are skipped"));
        let more: usize = more.filter_map(|n| n.split(' ').next()?.parse::<usize>().ok()).sum();
        assert_eq!((warnings.len() + more, places.len()), (report.skipped, warnings.len()), "{}", path.display());

        // All statements of the file are accounted for, but for those in branches that do not hold.
        let mut sources = text::Sources::default();
        let file = sources.add_bytes(path.display().to_string(), std::fs::read(&path).unwrap());
        let text = sources.text(file).to_string();
        let (statements, _) = syntax::command::parse(file, &text);
        let done = report.executed + report.skipped;
        let branches = statements.iter().any(|s| {
            matches!(&s.kind, syntax::command::StatementKind::Command { keywords, .. }
                if keywords.first().is_some_and(|k| text[k.range()].eq_ignore_ascii_case("if")))
        });
        if branches {
            assert!(done <= statements.len(), "{}", path.display());
        } else {
            assert_eq!(done, statements.len(), "{}", path.display());
        }
    }
}

/// Twin: the solver dataset of the same model, written by Adams.
#[test]
fn exports_hold_as_many_parts_markers_joints_and_beams_as_their_datasets() {
    let mut compared = 0;
    for path in exports() {
        let mut datasets = Vec::new();
        files(path.parent().unwrap(), "adm", &mut datasets);
        let (interpreter, report) = read(&path);
        let database = &interpreter.database;
        let skipped = skipped(&report);
        let not_executed = |start: &str| -> usize {
            skipped.iter().filter(|(path, _)| path.starts_with(start)).map(|(_, times)| times).sum()
        };
        for dataset in datasets {
            let text = String::from_utf8_lossy(&std::fs::read(&dataset).unwrap()).into_owned();
            let mut sources = text::Sources::default();
            let file = sources.add(dataset.display().to_string(), text.as_str());
            let statements = dataset::read_statements(&elements::registry(), file, &text);
            // The first line names the model the dataset was written from.
            let model = statements.title.rsplit(' ').next().unwrap_or("");
            // The name Adams gives to a new model says nothing: `test.adm` is not that of its neighbour.
            if model == "MODEL_1" {
                continue;
            }
            let Some(model) = database.find(&format!(".{model}"), "model") else { continue };
            compared += 1;
            let count = |family: &str| {
                database.subtree(model).iter().filter(|id| database.object(**id).class.is(family)).count()
            };
            // The writer of a dataset makes a marker for each solid that stands in a file of its own,
            // and Flexure has named that file as not read.
            let solids = statements.statements.iter().filter(|s| s.name == "GRAPHICS" && s.has("EXTERNAL")).count();
            assert!(solids == 0 || not_executed("file parasolid read") > 0, "{}", path.display());
            let found = [
                // The ground is a part in both.
                ("PART", count("part") + not_executed("part create rigid_body")),
                ("MARKER", count("marker") + count("floating_marker") + solids),
                ("JOINT", count("joint") + not_executed("constraint create joint")),
                ("BEAM", count("beam")),
            ];
            for (statement, found) in found {
                println!("{} {statement}: {found}", path.display());
                assert_eq!(found, statements.count(statement), "{statement} of {}", path.display());
            }
        }
    }
    if std::env::var_os("FLEXURE_SHARED").is_some() {
        assert!(compared >= 4, "only {compared} models stand beside a dataset");
    }
}
