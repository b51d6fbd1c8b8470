//! `flexure diff`: what is different between two models, or how far two results are apart.

use std::mem::ManuallyDrop;
use std::path::Path;

use comfy_table::{CellAlignment, Table, presets};
use flexure::results::compare;
use flexure::{ModelChange, ModelDifferences, Session, Why};
use serde_json::{Value, json};

use crate::Outcome;
use crate::arguments::{Diff, DiffFormat};
use crate::commands::{complain, count, mention_other_models, print, read, session};
use crate::output::{extension, read_table};

pub(super) fn execute(diff: &Diff) -> Outcome {
    let is_results = |path: &Path| matches!(extension(path).as_str(), "csv" | "parquet");
    match (is_results(&diff.a), is_results(&diff.b)) {
        (true, true) => results(diff),
        (false, false) => models(diff),
        _ => {
            complain("results (.csv, .parquet) are compared with results, models with models");
            Outcome::Usage
        }
    }
}

fn models(diff: &Diff) -> Outcome {
    if diff.a == Path::new("-") && diff.b == Path::new("-") {
        complain("only one of the two models can be standard input");
        return Outcome::Usage;
    }
    let (Some(a), Some(b)) = (model(&diff.a), model(&diff.b)) else { return Outcome::Findings };
    let differences = match a.compare(&b, diff.tolerance) {
        Ok(differences) => differences,
        Err(diagnostics) => {
            print(&a, &diagnostics);
            return Outcome::Findings;
        }
    };
    match diff.format {
        DiffFormat::Text => text(&differences),
        DiffFormat::Json => println!("{:#}", as_json(&differences)),
    }
    if differences.is_empty() { Outcome::Fine } else { Outcome::Findings }
}

/// Reads a model; none if it has errors, for half a model cannot be compared.
fn model(path: &Path) -> Option<ManuallyDrop<Session>> {
    let mut session = session();
    session.touch_nothing(true);
    let report = read(&mut session, path);
    let errors: Vec<_> = report.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
    print(&session, &errors);
    if report.has_errors() {
        complain(format_args!("{} was not read in full and is not compared", path.display()));
        return None;
    }
    if session.model().is_none() {
        complain(format_args!("{} creates no model", path.display()));
        return None;
    }
    mention_other_models(&session, &format!("compared of {}", path.display()));
    Some(session)
}

fn text(differences: &ModelDifferences) {
    for note in &differences.notes {
        println!("note: {note}");
    }
    let mut about = "";
    for change in &differences.changes {
        match change {
            ModelChange::Removed { class, name, below } => println!("removed  {class} {name}{}", with(*below)),
            ModelChange::Added { class, name, below } => println!("added    {class} {name}{}", with(*below)),
            ModelChange::Renamed { class, from, to } => println!("renamed  {class} {from} -> {to}"),
            ModelChange::Command { text, added: true } => println!("added    command {text}"),
            ModelChange::Command { text, added: false } => println!("removed  command {text}"),
            ModelChange::Value(value) => {
                if about != value.name {
                    println!("changed  {} {}", value.class, value.name);
                    about = &value.name;
                }
                let side = |text: &Option<String>| text.clone().unwrap_or_else(|| "(unset)".into());
                let why = match value.why {
                    Why::Given => "",
                    Why::SameValue => "   (the value is the same)",
                    Why::SameExpression => "   (by the same expression)",
                };
                println!("            {}: {} -> {}{why}", value.attribute, side(&value.before), side(&value.after));
            }
        }
    }
    if differences.is_empty() {
        println!("no difference");
    } else {
        println!("{}", count(differences.changes.len(), "difference"));
    }
}

fn with(below: usize) -> String {
    if below == 0 { String::new() } else { format!(" with {} below it", count(below, "object")) }
}

fn as_json(differences: &ModelDifferences) -> Value {
    let changes: Vec<Value> = differences
        .changes
        .iter()
        .map(|change| match change {
            ModelChange::Removed { class, name, below } => {
                json!({ "kind": "removed", "class": class, "object": name, "below": below })
            }
            ModelChange::Added { class, name, below } => {
                json!({ "kind": "added", "class": class, "object": name, "below": below })
            }
            ModelChange::Renamed { class, from, to } => {
                json!({ "kind": "renamed", "class": class, "from": from, "to": to })
            }
            ModelChange::Command { text, added } => {
                json!({ "kind": if *added { "added" } else { "removed" }, "command": text })
            }
            ModelChange::Value(value) => json!({
                "kind": "changed", "class": value.class, "object": value.name, "attribute": value.attribute,
                "before": value.before, "after": value.after,
                "why": match value.why {
                    Why::Given => "given",
                    Why::SameValue => "same value",
                    Why::SameExpression => "same expression",
                },
            }),
        })
        .collect();
    json!({ "equal": differences.is_empty(), "notes": differences.notes, "differences": changes })
}

fn results(diff: &Diff) -> Outcome {
    let mut tables = Vec::new();
    for path in [&diff.a, &diff.b] {
        match read_table(path) {
            Ok(table) => tables.push(table),
            Err(error) => {
                complain(format_args!("cannot read {}: {error}", path.display()));
                return Outcome::Findings;
            }
        }
    }
    let mut rows = Vec::new();
    for difference in compare(&tables[0], &tables[1]) {
        let relative = difference.largest.map(|(size, _)| if size == 0.0 { 0.0 } else { size / difference.size });
        if relative.is_none_or(|relative| relative > diff.tolerance) {
            rows.push((difference.name, difference.largest, relative));
        }
    }
    let equal = rows.is_empty();
    if diff.format == DiffFormat::Json {
        let rows: Vec<Value> = rows
            .iter()
            .map(|(name, largest, relative)| match largest {
                Some((size, time)) => json!({ "series": name, "largest": size, "time": time, "relative": relative }),
                None => json!({ "series": name, "only_in_one": true }),
            })
            .collect();
        println!("{:#}", json!({ "equal": equal, "differences": rows }));
    } else if equal {
        println!("no difference beyond {:e}", diff.tolerance);
    } else {
        println!("{}", table_of(rows));
    }
    if equal { Outcome::Fine } else { Outcome::Findings }
}

/// A series: its name, its largest difference with the time of it, and that relative to its size.
type Row = (String, Option<(f64, f64)>, Option<f64>);

fn table_of(rows: Vec<Row>) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_BORDERS_ONLY_CONDENSED);
    table.set_header(["series", "largest difference", "at time (s)", "relative"]);
    for (name, largest, relative) in rows {
        let row = match largest {
            Some((size, time)) => {
                [format!("{size:.6e}"), format!("{time}"), format!("{:.3e}", relative.unwrap_or_default())]
            }
            None => ["only in one file".into(), String::new(), String::new()],
        };
        table.add_row(std::iter::once(name).chain(row));
    }
    for column in 1..4 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}
