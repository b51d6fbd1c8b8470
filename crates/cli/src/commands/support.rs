//! `flexure support`: what is run, what is kept but not simulated, what is not supported.

use comfy_table::{Table, presets};

use crate::Outcome;

pub(super) fn execute() -> Outcome {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    table.set_header(["command", "state", "note"]);
    for entry in flexure::support() {
        table.add_row([entry.command, entry.state.to_string(), entry.note]);
    }
    println!("{table}");
    Outcome::Fine
}
