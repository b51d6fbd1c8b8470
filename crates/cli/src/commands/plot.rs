//! `flexure plot`: charts of results and pictures of models.

use std::path::Path;

use flexure::results::{Format, PictureRequest, PlotRequest, picture, plot};

use crate::Outcome;
use crate::arguments::{Edits, Plot};
use crate::commands::{complain, open, session};
use crate::output::{extension, read_table};

pub(super) fn execute(request: &Plot) -> Outcome {
    let format = match extension(&request.out).as_str() {
        "svg" => Format::Svg,
        "png" => Format::Png,
        other => {
            complain(format_args!("a picture ends in .svg or .png, not in `.{other}`"));
            return Outcome::Usage;
        }
    };
    let Some(size) = size(&request.size) else {
        complain(format_args!("`{}` is no size; write it as 1000x600, at most 10000x10000", request.size));
        return Outcome::Usage;
    };
    let name = request.input.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let title = request.title.clone().unwrap_or(name);
    let drawn = match extension(&request.input).as_str() {
        "csv" | "parquet" => draw_results(request, &title, size, format),
        _ => draw_model(&request.input, &title, size, format),
    };
    match drawn.and_then(|bytes| {
        std::fs::write(&request.out, bytes).map_err(|e| format!("cannot write {}: {e}", request.out.display()))
    }) {
        Ok(()) => {
            println!("{}", request.out.display());
            Outcome::Fine
        }
        Err(sentence) => {
            complain(sentence);
            Outcome::Findings
        }
    }
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
    picture(&session.drawing(), &PictureRequest { title, size, format, up: session.up_axis() })
        .map_err(|e| e.to_string())
}

fn size(text: &str) -> Option<(u32, u32)> {
    let (width, height) = text.split_once('x')?;
    let (width, height) = (width.trim().parse().ok()?, height.trim().parse().ok()?);
    let fits = 100..=10_000;
    (fits.contains(&width) && fits.contains(&height)).then_some((width, height))
}
