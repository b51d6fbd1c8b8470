//! `flexure modes`: eigenvalues, damping and shapes.

use std::io::Write;

use comfy_table::{CellAlignment, Table, presets};
use flexure::{Mode, ModesAbout};

use crate::Outcome;
use crate::arguments::Modes;
use crate::commands::{complain, open, print_found, session, set_beams};

pub(super) fn execute(modes: &Modes) -> Outcome {
    let mut session = session();
    set_beams(&mut session, &modes.beams);
    session.simulate_nothing(true);
    if !open(&mut session, &modes.model, &modes.edits) {
        complain("the model has errors; nothing was computed");
        return Outcome::Findings;
    }
    let about = match (&modes.about, modes.spin) {
        (Some(marker), Some(rate)) => ModesAbout::Spin { marker: marker.clone(), rate: rate.0 },
        _ if modes.statics => ModesAbout::Equilibrium,
        _ => ModesAbout::Present,
    };
    let found = match session.modes(&about) {
        Ok(found) => found,
        Err(diagnostics) => {
            print_found(&session, &diagnostics);
            return Outcome::Findings;
        }
    };
    print_found(&session, &found.diagnostics);
    if modes.json {
        let list: Vec<_> = found
            .modes
            .iter()
            .map(|m| {
                serde_json::json!({
                    "frequency_hz": m.frequency_hz, "damping_ratio": m.damping_ratio,
                    "real": m.real, "imaginary": m.imaginary,
                })
            })
            .collect();
        println!("{:#}", serde_json::json!({ "time": found.time, "modes": list }));
    } else {
        println!("{}", table(&found.modes, modes.most));
    }
    if let Some(path) = &modes.out {
        let written = std::fs::File::create(path).and_then(|file| write_shapes(&found, file));
        if let Err(error) = written {
            complain(format_args!("cannot write {}: {error}", path.display()));
            return Outcome::Findings;
        }
        println!("{}", path.display());
    }
    Outcome::Fine
}

fn table(modes: &[Mode], most: usize) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_BORDERS_ONLY_CONDENSED);
    table.set_header(["mode", "undamped natural frequency (Hz)", "damping ratio", "real (1/s)", "imaginary (rad/s)"]);
    for (number, m) in modes.iter().take(most).enumerate() {
        table.add_row([
            (number + 1).to_string(),
            format!("{:.6e}", m.frequency_hz),
            format!("{:.6e}", m.damping_ratio),
            format!("{:.6e}", m.real),
            format!("{:.6e}", m.imaginary),
        ]);
    }
    for column in 0..5 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// One row a mode: the figures, then the real and imaginary part of every unknown of the shape.
fn write_shapes(found: &flexure::ModesReport, file: std::fs::File) -> std::io::Result<()> {
    let mut out = std::io::BufWriter::new(file);
    write!(out, "mode,frequency_hz,damping_ratio,real,imaginary")?;
    for name in &found.unknowns {
        write!(out, ",\"{name} re\",\"{name} im\"")?;
    }
    writeln!(out)?;
    for (number, m) in found.modes.iter().enumerate() {
        write!(out, "{},{:?},{:?},{:?},{:?}", number + 1, m.frequency_hz, m.damping_ratio, m.real, m.imaginary)?;
        for (re, im) in &m.shape {
            write!(out, ",{re:?},{im:?}")?;
        }
        writeln!(out)?;
    }
    out.flush()
}
