//! Charts of series over time, as SVG or PNG: one panel for each unit, stacked.

use std::sync::Once;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use crate::{Series, Table};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Svg,
    Png,
}

/// What to draw.
#[derive(Clone, Debug)]
pub struct PlotRequest<'a> {
    pub title: &'a str,
    /// Names of the series; empty: the first that fit. A name ending in `*` stands for all that
    /// begin like it.
    pub series: Vec<String>,
    /// Width and height, pixels.
    pub size: (u32, u32),
    pub format: Format,
}

/// Why nothing could be drawn; a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotError(pub String);

impl std::fmt::Display for PlotError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PlotError {}

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
pub(crate) const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(153, 153, 153),
];

pub(crate) const FONT: &str = "flexure";
pub(crate) const INK: RGBColor = RGBColor(40, 40, 40);
pub(crate) const GRID: RGBColor = RGBColor(226, 226, 226);
/// Panels drawn at most; more would be unreadable.
const MOST_PANELS: usize = 4;
/// Series drawn when none is named.
const DEFAULT_SERIES: usize = 4;

pub(crate) type Drawn<E> = Result<(), DrawingAreaErrorKind<E>>;

/// Draws series of a table over its first series.
///
/// # Errors
/// If a name is unknown or there is nothing to draw.
pub fn plot(table: &Table, request: &PlotRequest) -> Result<Vec<u8>, PlotError> {
    let panels = panels(choose(table, &request.series)?);
    let time = &table.series[0];
    if time.values.is_empty() {
        return Err(PlotError("the results have no rows to plot".into()));
    }
    embed_font()?;
    match request.format {
        Format::Svg => svg(request.size, |root| draw(root, request.title, time, &panels, 1)),
        Format::Png => png(request.size, |root, scale| draw(root, request.title, time, &panels, scale)),
    }
}

/// Makes the embedded font known to the drawing library, once.
pub(crate) fn embed_font() -> Result<(), PlotError> {
    static ONCE: Once = Once::new();
    let mut registered = Ok(());
    ONCE.call_once(|| {
        for (style, bytes) in [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())] {
            if register_font(FONT, style, bytes).is_err() {
                registered = Err(PlotError("the embedded font cannot be read".into()));
            }
        }
    });
    registered
}

fn failed(error: impl std::fmt::Display) -> PlotError {
    PlotError(format!("the chart cannot be drawn: {error}"))
}

/// Runs a drawing as SVG.
pub(crate) fn svg(
    size: (u32, u32),
    draw: impl for<'a> FnOnce(&DrawingArea<SVGBackend<'a>, Shift>) -> Drawn<<SVGBackend<'a> as DrawingBackend>::ErrorType>,
) -> Result<Vec<u8>, PlotError> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(&root).map_err(failed)?;
        root.present().map_err(failed)?;
    }
    Ok(text.into_bytes())
}

/// Pixels drawn for one pixel of a PNG, in each direction: lines come out smooth.
const OVERSAMPLING: u32 = 3;

/// Runs a drawing as PNG. The drawing is told by which factor everything is larger while it draws.
pub(crate) fn png(
    size: (u32, u32),
    draw: impl for<'a> FnOnce(
        &DrawingArea<BitMapBackend<'a>, Shift>,
        u32,
    ) -> Drawn<<BitMapBackend<'a> as DrawingBackend>::ErrorType>,
) -> Result<Vec<u8>, PlotError> {
    let large = (size.0 * OVERSAMPLING, size.1 * OVERSAMPLING);
    let mut drawn = vec![255; large.0 as usize * large.1 as usize * 3];
    {
        let root = BitMapBackend::with_buffer(&mut drawn, large).into_drawing_area();
        draw(&root, OVERSAMPLING).map_err(failed)?;
        root.present().map_err(failed)?;
    }
    let pixels = shrink(&drawn, size);
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size.0, size.1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&pixels).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(file)
}

/// Averages squares of pixels.
fn shrink(large: &[u8], (width, height): (u32, u32)) -> Vec<u8> {
    let (width, height, factor) = (width as usize, height as usize, OVERSAMPLING as usize);
    let stride = width * factor * 3;
    let mut small = Vec::with_capacity(width * height * 3);
    for y in 0..height {
        for x in 0..width {
            for channel in 0..3 {
                let first = y * factor * stride + x * factor * 3 + channel;
                let sum: usize = (0..factor * factor)
                    .map(|k| usize::from(large[first + (k / factor) * stride + (k % factor) * 3]))
                    .sum();
                small.push((sum / (factor * factor)) as u8);
            }
        }
    }
    small
}

fn choose<'t>(table: &'t Table, names: &[String]) -> Result<Vec<&'t Series>, PlotError> {
    let columns = table.series.get(1..).unwrap_or_default();
    if names.is_empty() {
        return if columns.is_empty() {
            Err(PlotError("the results have no series beside time".into()))
        } else {
            Ok(columns.iter().filter(|s| s.unit == columns[0].unit).take(DEFAULT_SERIES).collect())
        };
    }
    let mut chosen = Vec::new();
    for name in names {
        let before = chosen.len();
        match name.strip_suffix('*') {
            Some(head) => chosen
                .extend(columns.iter().filter(|s| s.name.to_ascii_lowercase().starts_with(&head.to_ascii_lowercase()))),
            None => chosen.extend(table.get(name)),
        }
        if chosen.len() == before {
            let known: Vec<&str> = columns.iter().take(6).map(|s| s.name.as_str()).collect();
            return Err(PlotError(format!("there is no series `{name}`; the results have {} ...", known.join(", "))));
        }
    }
    Ok(chosen)
}

/// Groups series by unit, in order of first appearance.
fn panels(chosen: Vec<&Series>) -> Vec<Vec<&Series>> {
    let mut panels: Vec<Vec<&Series>> = Vec::new();
    for series in chosen {
        match panels.iter_mut().find(|p| p[0].unit == series.unit) {
            Some(panel) => panel.push(series),
            None => panels.push(vec![series]),
        }
    }
    panels.truncate(MOST_PANELS);
    panels
}

fn draw<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    title: &str,
    time: &Series,
    panels: &[Vec<&Series>],
    scale: u32,
) -> Drawn<B::ErrorType> {
    root.fill(&WHITE)?;
    let body = root.margin(8 * scale, 0, 0, 0).titled(title, (FONT, 20 * scale).into_font().color(&INK))?;
    let areas = body.split_evenly((panels.len(), 1));
    for (index, (area, panel)) in areas.iter().zip(panels).enumerate() {
        draw_panel(area, time, panel, index + 1 == panels.len(), scale)?;
    }
    Ok(())
}

fn draw_panel<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    time: &Series,
    panel: &[&Series],
    last: bool,
    scale: u32,
) -> Drawn<B::ErrorType> {
    let (t0, t1) = span(time.values.iter().copied(), 0.0);
    let (y0, y1) = span(panel.iter().flat_map(|s| s.values.iter().copied()), 0.06);
    let mut chart = ChartBuilder::on(area)
        .margin(12 * scale)
        .margin_right(24 * scale)
        .x_label_area_size(scale * if last { 46 } else { 28 })
        .y_label_area_size(92 * scale)
        .build_cartesian_2d(t0..t1, y0..y1)?;
    let step = |from: f64, to: f64| (to - from) / 8.0;
    let (x_step, y_step) = (step(t0, t1), step(y0, y1));
    let unit = panel[0].unit.as_str();
    let y_title = if panel.len() == 1 && !unit.is_empty() {
        format!("{} ({unit})", panel[0].name)
    } else if unit.is_empty() {
        if panel.len() == 1 { panel[0].name.clone() } else { String::new() }
    } else {
        unit.to_string()
    };
    let mut mesh = chart.configure_mesh();
    let (x_label, y_label) = (move |x: &f64| tick(*x, x_step), move |y: &f64| tick(*y, y_step));
    mesh.light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(scale))
        .axis_style(INK.stroke_width(scale))
        .label_style((FONT, 13 * scale).into_font().color(&INK))
        .axis_desc_style((FONT, 14 * scale).into_font().color(&INK))
        .set_all_tick_mark_size(5 * scale)
        .x_label_formatter(&x_label)
        .y_label_formatter(&y_label)
        .x_labels(10)
        .y_labels(7)
        .y_desc(y_title);
    if last {
        let unit = if time.unit.is_empty() { "s" } else { time.unit.as_str() };
        mesh.x_desc(format!("time ({unit})"));
    }
    mesh.draw()?;
    for (index, series) in panel.iter().enumerate() {
        let colour = PALETTE[index % PALETTE.len()];
        let points = time.values.iter().copied().zip(series.values.iter().copied()).filter(|p| p.1.is_finite());
        if time.values.len() == 1 {
            // One output, as of a static solution, is a point.
            chart.draw_series(points.clone().map(|p| Circle::new(p, 4 * scale, colour.filled())))?;
        }
        chart.draw_series(LineSeries::new(points, colour.stroke_width(2 * scale)))?.label(series.name.as_str()).legend(
            move |(x, y)| PathElement::new([(x, y), (x + 22 * scale as i32, y)], colour.stroke_width(2 * scale)),
        );
    }
    if panel.len() > 1 {
        draw_legend(&mut chart, scale)?;
    }
    Ok(())
}

/// The names of what was drawn, in a corner of the chart.
pub(crate) fn draw_legend<'a, B: DrawingBackend + 'a>(
    chart: &mut ChartContext<'a, B, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
    scale: u32,
) -> Drawn<B::ErrorType> {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .legend_area_size(30 * scale)
        .margin(8 * scale)
        .background_style(WHITE.mix(0.85))
        .border_style(GRID.stroke_width(scale))
        .label_font((FONT, 13 * scale).into_font().color(&INK))
        .draw()
}

/// Range of finite values, widened by a fraction on both sides; never empty.
pub(crate) fn span(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) =
        values.filter(|x| x.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if low > high {
        return (0.0, 1.0);
    }
    let size = high - low;
    if size <= 1e-12 * high.abs().max(1e-300) {
        let half = if high == 0.0 { 1.0 } else { 0.1 * high.abs() };
        return (low - half, high + half);
    }
    (low - margin * size, high + margin * size)
}

/// A tick label with as many digits as the distance between ticks asks for.
pub(crate) fn tick(value: f64, step: f64) -> String {
    let value = if value.abs() < 1e-9 * step { 0.0 } else { value };
    let size = value.abs();
    if size >= 1e6 || (size > 0.0 && size < 1e-4) {
        return format!("{value:.2e}");
    }
    let decimals = (-step.log10()).ceil().clamp(0.0, 8.0) as usize + usize::from(step < 1.0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swing() -> Table {
        let columns = [("time", "second"), ("TIP.X", "mm"), ("TIP.Z", "mm"), ("beam.FX", "newton")];
        let mut table = Table::with_columns(columns.map(|(n, u)| (n.to_string(), u.to_string())));
        for k in 0..200 {
            let t = f64::from(k) * 0.01;
            table.push(&[t, 120.0 * (6.0 * t).cos(), 80.0 * (6.0 * t).sin(), 3.0e4 * (12.0 * t).sin()]);
        }
        table
    }

    fn request(series: &[&str], format: Format) -> PlotRequest<'static> {
        let series = series.iter().map(ToString::to_string).collect();
        PlotRequest { title: "swing", series, size: (900, 600), format }
    }

    #[test]
    fn a_chart_names_its_series_and_units() {
        let svg = String::from_utf8(plot(&swing(), &request(&[], Format::Svg)).unwrap()).unwrap();
        for text in ["swing", "TIP.X", "TIP.Z", "mm", "time (second)"] {
            assert!(svg.contains(text), "{text} is missing");
        }
    }

    #[test]
    fn a_png_has_the_size_asked_for() {
        let file = plot(&swing(), &request(&["tip.*"], Format::Png)).unwrap();
        let reader = png::Decoder::new(file.as_slice()).read_info().unwrap();
        assert_eq!((reader.info().width, reader.info().height), (900, 600));
    }

    #[test]
    fn an_unknown_series_is_named_with_those_there_are() {
        let error = plot(&swing(), &request(&["TIP.Q"], Format::Svg)).unwrap_err();
        assert!(error.0.contains("`TIP.Q`") && error.0.contains("TIP.X"));
    }

    #[test]
    fn ticks_show_the_digits_that_matter() {
        assert_eq!(tick(0.30000000000000004, 0.1), "0.3");
        assert_eq!(tick(-0.0, 1.0), "0");
        assert_eq!(tick(2.5e7, 5e6), "2.50e7");
        assert_eq!(tick(150.0, 50.0), "150");
    }
}
