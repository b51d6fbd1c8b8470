//! Diagrams of quantities along something: one panel for each kind of quantity, stacked over one axis,
//! filled towards zero as engineers draw what goes through a structure.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::plot::{Drawn, FONT, GRID, INK, PALETTE, draw_legend, embed_font, png, span, svg, tick};
use crate::{Format, PlotError};

/// A curve in pieces; between pieces nothing is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub name: String,
    pub pieces: Vec<Vec<(f64, f64)>>,
}

/// Curves that share an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Name and unit of what is drawn.
    pub title: String,
    pub curves: Vec<Curve>,
}

/// What to draw.
#[derive(Clone, Debug)]
pub struct DiagramRequest<'a> {
    pub title: &'a str,
    /// Name and unit of the axis that the panels share.
    pub along: &'a str,
    pub panels: &'a [Panel],
    /// Places along the axis that are marked in every panel.
    pub marks: &'a [f64],
    /// Width and height, pixels.
    pub size: (u32, u32),
    pub format: Format,
}

/// Draws the panels.
///
/// # Errors
/// If there is nothing to draw.
pub fn diagram(request: &DiagramRequest<'_>) -> Result<Vec<u8>, PlotError> {
    let points = || request.panels.iter().flat_map(|p| &p.curves).flat_map(|c| &c.pieces).flatten();
    if points().next().is_none() {
        return Err(PlotError("there is nothing to draw".into()));
    }
    embed_font()?;
    let along = span(points().map(|p| p.0).chain(request.marks.iter().copied()), 0.0);
    match request.format {
        Format::Svg => svg(request.size, |root| draw(root, request, along, 1)),
        Format::Png => png(request.size, |root, scale| draw(root, request, along, scale)),
    }
}

fn draw<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    request: &DiagramRequest<'_>,
    along: (f64, f64),
    scale: u32,
) -> Drawn<B::ErrorType> {
    root.fill(&WHITE)?;
    let body = root.margin(8 * scale, 0, 0, 0).titled(request.title, (FONT, 20 * scale).into_font().color(&INK))?;
    let areas = body.split_evenly((request.panels.len(), 1));
    for (index, (area, panel)) in areas.iter().zip(request.panels).enumerate() {
        let below = (index + 1 == request.panels.len()).then_some(request.along);
        draw_panel(area, panel, below, along, request.marks, scale)?;
    }
    Ok(())
}

fn draw_panel<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    panel: &Panel,
    below: Option<&str>,
    (x0, x1): (f64, f64),
    marks: &[f64],
    scale: u32,
) -> Drawn<B::ErrorType> {
    let values = panel.curves.iter().flat_map(|c| &c.pieces).flatten().map(|p| p.1);
    let (y0, y1) = span(values.chain([0.0]), 0.08);
    let mut chart = ChartBuilder::on(area)
        .margin(10 * scale)
        .margin_right(24 * scale)
        .x_label_area_size(scale * if below.is_some() { 46 } else { 26 })
        .y_label_area_size(92 * scale)
        .build_cartesian_2d(x0..x1, y0..y1)?;
    let (x_step, y_step) = ((x1 - x0) / 8.0, (y1 - y0) / 8.0);
    let (x_label, y_label) = (move |x: &f64| tick(*x, x_step), move |y: &f64| tick(*y, y_step));
    let mut mesh = chart.configure_mesh();
    mesh.light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(scale))
        .axis_style(INK.stroke_width(scale))
        .label_style((FONT, 13 * scale).into_font().color(&INK))
        .axis_desc_style((FONT, 14 * scale).into_font().color(&INK))
        .set_all_tick_mark_size(5 * scale)
        .x_label_formatter(&x_label)
        .y_label_formatter(&y_label)
        .disable_x_mesh()
        .x_labels(10)
        .y_labels(5)
        .y_desc(panel.title.as_str());
    if let Some(title) = below {
        mesh.x_desc(title);
    }
    mesh.draw()?;
    let faint = GRID.stroke_width(scale);
    chart.draw_series(marks.iter().map(|x| PathElement::new([(*x, y0), (*x, y1)], faint)))?;
    for (index, curve) in panel.curves.iter().enumerate() {
        let colour = PALETTE[index % PALETTE.len()];
        let filled = |piece: &Vec<(f64, f64)>| {
            let (first, last) = (piece.first().map_or(x0, |p| p.0), piece.last().map_or(x0, |p| p.0));
            let outline: Vec<(f64, f64)> =
                [(first, 0.0)].into_iter().chain(piece.iter().copied()).chain([(last, 0.0)]).collect();
            Polygon::new(outline, colour.mix(0.14).filled())
        };
        chart.draw_series(curve.pieces.iter().map(filled))?;
        for (number, piece) in curve.pieces.iter().enumerate() {
            let line = chart.draw_series(LineSeries::new(piece.iter().copied(), colour.stroke_width(2 * scale)))?;
            if number == 0 && panel.curves.len() > 1 {
                line.label(curve.name.as_str()).legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 22 * scale as i32, y)], colour.stroke_width(2 * scale))
                });
            }
        }
    }
    chart.draw_series([PathElement::new([(x0, 0.0), (x1, 0.0)], INK.stroke_width(scale))])?;
    if panel.curves.len() > 1 {
        draw_legend(&mut chart, scale)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment() -> Panel {
        let curve = |name: &str, end: f64| Curve { name: name.into(), pieces: vec![vec![(0.0, end), (500.0, 0.0)]] };
        Panel { title: "M (newton-mm)".into(), curves: vec![curve("My", -2e5), curve("Mz", 1e5)] }
    }

    fn request(panels: &[Panel], format: Format) -> Result<Vec<u8>, PlotError> {
        let (title, along, marks) = ("cantilever", "x (mm)", [0.0, 250.0, 500.0]);
        diagram(&DiagramRequest { title, along, panels, marks: &marks, size: (800, 300), format })
    }

    #[test]
    fn a_diagram_names_what_it_shows_and_fills_towards_zero() {
        let svg = String::from_utf8(request(&[moment()], Format::Svg).unwrap()).unwrap();
        for text in ["cantilever", "x (mm)", "M (newton-mm)", "My", "Mz"] {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert_eq!(svg.matches("<polygon").count(), 2);
    }

    #[test]
    fn a_png_has_the_size_asked_for() {
        let file = request(&[moment()], Format::Png).unwrap();
        let reader = ::png::Decoder::new(file.as_slice()).read_info().unwrap();
        assert_eq!((reader.info().width, reader.info().height), (800, 300));
    }

    #[test]
    fn nothing_to_draw_is_an_error() {
        assert!(request(&[], Format::Svg).is_err());
    }
}
