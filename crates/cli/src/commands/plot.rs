//! `flexure plot`: charts of results and pictures of models.

use std::path::Path;

use flexure::results::{Format, PictureRequest, PlotRequest, picture, plot};

use crate::Outcome;
use crate::arguments::{Edits, Plot};
use crate::commands::{open, picture_format, picture_size, print, save_picture, session};
use crate::output::{extension, read_table};

pub(super) fn execute(request: &Plot) -> Outcome {
    let Some(format) = picture_format(&request.out) else { return Outcome::Usage };
    let Some(size) = picture_size(&request.size) else { return Outcome::Usage };
    let name = request.input.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let title = request.title.clone().unwrap_or(name);
    let drawn = match extension(&request.input).as_str() {
        "csv" | "parquet" => draw_results(request, &title, size, format),
        _ => draw_model(&request.input, &title, size, format),
    };
    save_picture(&request.out, drawn, true)
}

fn draw_results(request: &Plot, title: &str, size: (u32, u32), format: Format) -> Result<Vec<u8>, String> {
    let table = read_table(&request.input).map_err(|e| format!("cannot read {}: {e}", request.input.display()))?;
    plot(&table, &PlotRequest { title, series: request.series.clone(), size, format }).map_err(|e| e.to_string())
}

fn draw_model(path: &Path, title: &str, size: (u32, u32), format: Format) -> Result<Vec<u8>, String> {
    let mut session = session();
    session.simulate_nothing(true);
    if !open(&mut session, path, &Edits { commands: Vec::new() }) {
        return Err(format!("{} has errors", path.display()));
    }
    print(&session, &session.not_drawn());
    picture(&session.drawing(), &PictureRequest { title, size, format, up: session.up_axis() })
        .map_err(|e| e.to_string())
}
