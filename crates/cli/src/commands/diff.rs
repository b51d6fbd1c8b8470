//! `flexure diff`: how far two results are apart.

use comfy_table::{CellAlignment, Table, presets};
use flexure::results::compare;

use crate::Outcome;
use crate::arguments::Diff;
use crate::commands::complain;
use crate::output::read_table;

pub(super) fn execute(diff: &Diff) -> Outcome {
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
    let mut table = Table::new();
    table.load_preset(presets::ASCII_BORDERS_ONLY_CONDENSED);
    table.set_header(["series", "largest difference", "at time (s)", "relative"]);
    let mut equal = true;
    for difference in compare(&tables[0], &tables[1]) {
        let row = match difference.largest {
            Some((size, time)) => {
                let relative = if size == 0.0 { 0.0 } else { size / difference.size };
                if relative <= diff.tolerance {
                    continue;
                }
                [format!("{size:.6e}"), format!("{time}"), format!("{relative:.3e}")]
            }
            None => ["only in one file".into(), String::new(), String::new()],
        };
        equal = false;
        table.add_row(std::iter::once(difference.name).chain(row));
    }
    if equal {
        println!("no difference beyond {:e}", diff.tolerance);
        return Outcome::Fine;
    }
    for column in 1..4 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    println!("{table}");
    Outcome::Findings
}
