//! Plane shapes with their sizes marked: cross sections.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::plot::{Drawn, FONT, INK, PALETTE, embed_font, png, svg};
use crate::{Format, PlotError};

/// On which side of its line the text of a mark stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextSide {
    Left,
    Right,
    Above,
    Below,
}

/// A size: a line with short strokes at its ends, and a text beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeMark {
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub text: String,
    pub side: TextSide,
}

/// What to draw.
#[derive(Clone, Debug)]
pub struct OutlineRequest<'a> {
    pub title: &'a str,
    /// Closed lines, the first filled and the others cut out of it; the first axis points to the
    /// right, the second up.
    pub outlines: &'a [Vec<[f64; 2]>],
    /// Names of the two axes, drawn through the origin.
    pub axes: [&'a str; 2],
    pub marks: &'a [SizeMark],
    /// Lines of text beside the drawing.
    pub lines: &'a [String],
    /// Width and height, pixels.
    pub size: (u32, u32),
    pub format: Format,
}

/// Draws a plane shape.
///
/// # Errors
/// If there is nothing to draw.
pub fn outline(request: &OutlineRequest) -> Result<Vec<u8>, PlotError> {
    let frame = Frame::around(request).ok_or_else(|| PlotError("the shape has no extent to draw".into()))?;
    embed_font()?;
    match request.format {
        Format::Svg => svg(request.size, |root| draw(root, request, &Frame { scale: 1, ..frame })),
        Format::Png => png(request.size, |root, scale| draw(root, request, &Frame { scale, ..frame })),
    }
}

/// Pixels that texts beside the drawing take.
const BESIDE: f64 = 330.0;

/// Where the drawing lies on the canvas.
#[derive(Clone, Copy)]
struct Frame {
    /// Pixels for a unit of length.
    zoom: f64,
    centre: [f64; 2],
    middle: [f64; 2],
    reach: [f64; 2],
    /// How much larger the canvas is than the picture.
    scale: u32,
}

impl Frame {
    fn around(request: &OutlineRequest) -> Option<Frame> {
        let marks = request.marks.iter().flat_map(|m| [m.from, m.to]);
        let points = request.outlines.iter().flatten().copied().chain(marks);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in points.filter(|p| p[0].is_finite() && p[1].is_finite()) {
            for k in 0..2 {
                low[k] = low[k].min(p[k]);
                high[k] = high[k].max(p[k]);
            }
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let size = extent[0].max(extent[1]);
        if size.is_nan() || size <= 0.0 {
            return None;
        }
        let beside = if request.lines.is_empty() { 0.0 } else { BESIDE };
        // Room for the texts of marks and the arrows of axes.
        let room = [f64::from(request.size.0) - beside - 180.0, f64::from(request.size.1) - 190.0];
        let zoom = (room[0].max(40.0) / extent[0].max(1e-300)).min(room[1].max(40.0) / extent[1].max(1e-300));
        Some(Frame {
            zoom,
            centre: [f64::midpoint(low[0], high[0]), f64::midpoint(low[1], high[1])],
            middle: [(f64::from(request.size.0) - beside) / 2.0 + 20.0, f64::from(request.size.1) / 2.0 + 15.0],
            reach: high,
            scale: 1,
        })
    }

    fn pixel(&self, p: [f64; 2]) -> (i32, i32) {
        let x = self.middle[0] + (p[0] - self.centre[0]) * self.zoom;
        let y = self.middle[1] - (p[1] - self.centre[1]) * self.zoom;
        ((x * f64::from(self.scale)).round() as i32, (y * f64::from(self.scale)).round() as i32)
    }

    /// A number of pixels of the picture on the canvas.
    fn far(&self, pixels: i32) -> i32 {
        pixels * self.scale as i32
    }
}

fn draw<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    request: &OutlineRequest,
    frame: &Frame,
) -> Drawn<B::ErrorType> {
    let scale = frame.scale;
    root.fill(&WHITE)?;
    root.margin(8 * scale, 0, 0, 0).titled(request.title, (FONT, 20 * scale).into_font().color(&INK))?;
    for (index, points) in request.outlines.iter().enumerate() {
        let mut pixels: Vec<(i32, i32)> = points.iter().map(|p| frame.pixel(*p)).collect();
        pixels.extend(pixels.first().copied());
        let inside = if index == 0 { RGBColor(205, 224, 238) } else { WHITE };
        root.draw(&Polygon::new(pixels.clone(), inside.filled()))?;
        root.draw(&PathElement::new(pixels, PALETTE[0].stroke_width(2 * scale)))?;
    }
    draw_axes(root, request, frame)?;
    for mark in request.marks {
        draw_mark(root, mark, frame)?;
    }
    let style = (FONT, 14 * scale).into_font().color(&INK);
    for (row, line) in request.lines.iter().enumerate() {
        let x = request.size.0 as i32 - BESIDE as i32 + 10;
        root.draw(&Text::new(line.as_str(), (frame.far(x), frame.far(70 + 24 * row as i32)), style.clone()))?;
    }
    Ok(())
}

/// Arrows from the origin beyond the shape.
fn draw_axes<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    request: &OutlineRequest,
    frame: &Frame,
) -> Drawn<B::ErrorType> {
    let origin = frame.pixel([0.0, 0.0]);
    let (right, top) = (frame.pixel([frame.reach[0], 0.0]), frame.pixel([0.0, frame.reach[1]]));
    let ends = [(right.0 + frame.far(40), origin.1), (origin.0, top.1 - frame.far(50))];
    let line = INK.stroke_width(frame.scale);
    let style = TextStyle::from((FONT, 15 * frame.scale).into_font()).color(&INK);
    for (k, end) in ends.into_iter().enumerate() {
        root.draw(&PathElement::new([origin, end], line))?;
        let back = |along: i32, across: i32| match k {
            0 => (end.0 - frame.far(along), end.1 + frame.far(across)),
            _ => (end.0 + frame.far(across), end.1 + frame.far(along)),
        };
        root.draw(&Polygon::new([end, back(9, -4), back(9, 4)], INK.filled()))?;
        let place = back(-10, 0);
        root.draw(&Text::new(request.axes[k], place, style.pos(Pos::new(HPos::Center, VPos::Center))))?;
    }
    Ok(())
}

fn draw_mark<B: DrawingBackend>(root: &DrawingArea<B, Shift>, mark: &SizeMark, frame: &Frame) -> Drawn<B::ErrorType> {
    let (a, b) = (frame.pixel(mark.from), frame.pixel(mark.to));
    let colour = PALETTE[1];
    let line = colour.stroke_width(frame.scale);
    root.draw(&PathElement::new([a, b], line))?;
    let stroke = frame.far(5);
    // Strokes stand across the line, which is level or upright.
    let across = if a.1 == b.1 { (0, stroke) } else { (stroke, 0) };
    for end in [a, b] {
        let strokes = [(end.0 - across.0, end.1 - across.1), (end.0 + across.0, end.1 + across.1)];
        root.draw(&PathElement::new(strokes, line))?;
    }
    let middle = (i32::midpoint(a.0, b.0), i32::midpoint(a.1, b.1));
    let gap = frame.far(9);
    let (place, h, v) = match mark.side {
        TextSide::Left => ((a.0.min(b.0) - gap, middle.1), HPos::Right, VPos::Center),
        TextSide::Right => ((a.0.max(b.0) + gap, middle.1), HPos::Left, VPos::Center),
        TextSide::Above => ((middle.0, a.1.min(b.1) - gap), HPos::Center, VPos::Bottom),
        TextSide::Below => ((middle.0, a.1.max(b.1) + gap), HPos::Center, VPos::Top),
    };
    let style = TextStyle::from((FONT, 14 * frame.scale).into_font()).color(&colour);
    root.draw(&Text::new(mark.text.as_str(), place, style.pos(Pos::new(h, v))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_is_drawn_with_its_sizes_and_nothing_is_an_error() {
        let square = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let mark = SizeMark { from: [-1.0, -1.2], to: [1.0, -1.2], text: "width 2".into(), side: TextSide::Below };
        let (outlines, marks, lines) = ([square], [mark], ["A = 4".to_string()]);
        let request = OutlineRequest {
            title: "square",
            outlines: &outlines,
            axes: ["y", "z"],
            marks: &marks,
            lines: &lines,
            size: (800, 500),
            format: Format::Svg,
        };
        let svg = String::from_utf8(outline(&request).unwrap()).unwrap();
        for text in ["square", "width 2", "A = 4", "polygon"] {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert!(!outline(&OutlineRequest { format: Format::Png, ..request.clone() }).unwrap().is_empty());
        assert!(outline(&OutlineRequest { outlines: &[], marks: &[], ..request }).is_err());
    }
}
