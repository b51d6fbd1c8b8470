//! Line pictures of a model in space, in isometric projection; several instants can be overlaid.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::plot::{Drawn, FONT, INK, embed_font, png, svg};
use crate::{Format, PlotError};

/// A line in space with a colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline {
    /// Points in global axes, any length unit.
    pub points: Vec<[f64; 3]>,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// 1 is opaque; earlier instants of a motion are drawn fainter.
    pub opacity: f64,
    /// Width, pixels.
    pub width: u32,
}

/// What to draw.
#[derive(Clone, Debug)]
pub struct PictureRequest<'a> {
    pub title: &'a str,
    /// Width and height, pixels.
    pub size: (u32, u32),
    pub format: Format,
    /// Global axis that points up: 0, 1 or 2.
    pub up: usize,
}

/// Draws lines seen from the corner of the first octant.
///
/// # Errors
/// If there is nothing to draw.
pub fn picture(lines: &[Polyline], request: &PictureRequest) -> Result<Vec<u8>, PlotError> {
    let flat: Vec<(Vec<(f64, f64)>, &Polyline)> =
        lines.iter().map(|l| (l.points.iter().map(|p| project(*p, request.up)).collect(), l)).collect();
    let frame = Frame::around(flat.iter().flat_map(|(points, _)| points.iter().copied()), request.size)
        .ok_or_else(|| PlotError("the model has nothing to draw".into()))?;
    embed_font()?;
    match request.format {
        Format::Svg => svg(request.size, |root| draw(root, request, &flat, &frame, 1)),
        Format::Png => png(request.size, |root, scale| draw(root, request, &flat, &frame, scale)),
    }
}

/// Isometric projection: the up axis stays vertical, the two others go down to the left and right.
fn project(p: [f64; 3], up: usize) -> (f64, f64) {
    let (x, y, z) = (p[(up + 1) % 3], p[(up + 2) % 3], p[up % 3]);
    let (sine, cosine) = (0.5, 3.0_f64.sqrt() / 2.0);
    ((y - x) * cosine, z - (x + y) * sine)
}

/// Where the drawing lies on the canvas.
struct Frame {
    scale: f64,
    centre: (f64, f64),
    middle: (f64, f64),
}

impl Frame {
    fn around(points: impl Iterator<Item = (f64, f64)>, size: (u32, u32)) -> Option<Frame> {
        let mut low = (f64::INFINITY, f64::INFINITY);
        let mut high = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        for (x, y) in points.filter(|(x, y)| x.is_finite() && y.is_finite()) {
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        }
        if low.0 > high.0 {
            return None;
        }
        let room = (f64::from(size.0) - 60.0, f64::from(size.1) - 100.0);
        let extent = ((high.0 - low.0).max(1e-12), (high.1 - low.1).max(1e-12));
        Some(Frame {
            scale: (room.0 / extent.0).min(room.1 / extent.1),
            centre: (f64::midpoint(low.0, high.0), f64::midpoint(low.1, high.1)),
            middle: (f64::from(size.0) / 2.0, f64::from(size.1) / 2.0 + 15.0),
        })
    }

    /// Where a point lies on a canvas that is `scale` times larger than the picture.
    fn pixel(&self, p: (f64, f64), scale: u32) -> (i32, i32) {
        let x = self.middle.0 + (p.0 - self.centre.0) * self.scale;
        let y = self.middle.1 - (p.1 - self.centre.1) * self.scale;
        ((x * f64::from(scale)).round() as i32, (y * f64::from(scale)).round() as i32)
    }
}

fn draw<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    request: &PictureRequest,
    lines: &[(Vec<(f64, f64)>, &Polyline)],
    frame: &Frame,
    scale: u32,
) -> Drawn<B::ErrorType> {
    root.fill(&WHITE)?;
    root.margin(8 * scale, 0, 0, 0).titled(request.title, (FONT, 20 * scale).into_font().color(&INK))?;
    for (points, line) in lines {
        let [r, g, b] = line.colour;
        let style = RGBColor(r, g, b).mix(line.opacity).stroke_width(line.width.max(1) * scale);
        let pixels: Vec<(i32, i32)> = points.iter().map(|p| frame.pixel(*p, scale)).collect();
        root.draw(&PathElement::new(pixels, style))?;
    }
    draw_triad(root, request, scale)
}

/// The three axes in the lower left corner.
fn draw_triad<B: DrawingBackend>(
    root: &DrawingArea<B, Shift>,
    request: &PictureRequest,
    scale: u32,
) -> Drawn<B::ErrorType> {
    let factor = scale as i32;
    let corner = (60 * factor, (request.size.1 as i32 - 60) * factor);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mut unit = [0.0; 3];
        unit[axis] = 34.0 * f64::from(scale);
        let (dx, dy) = project(unit, request.up);
        let end = (corner.0 + dx as i32, corner.1 - dy as i32);
        root.draw(&PathElement::new([corner, end], INK.stroke_width(scale)))?;
        let place = (corner.0 + (dx * 1.25) as i32 - 4 * factor, corner.1 - (dy * 1.25) as i32 - 6 * factor);
        root.draw(&Text::new(name, place, (FONT, 13 * scale).into_font().color(&INK)))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(format: Format) -> PictureRequest<'static> {
        PictureRequest { title: "beam", size: (400, 300), format, up: 2 }
    }

    #[test]
    fn the_up_axis_points_up() {
        assert_eq!(project([0.0, 0.0, 1.0], 2), (0.0, 1.0));
        assert_eq!(project([0.0, 1.0, 0.0], 1), (0.0, 1.0));
    }

    #[test]
    fn lines_are_drawn_and_nothing_is_an_error() {
        let line = Polyline { points: vec![[0.0; 3], [1.0, 2.0, 3.0]], colour: [0, 114, 178], opacity: 1.0, width: 2 };
        let svg = String::from_utf8(picture(&[line], &request(Format::Svg)).unwrap()).unwrap();
        assert!(svg.contains("polyline") && svg.contains("beam"));
        assert!(picture(&[], &request(Format::Png)).is_err());
    }
}
