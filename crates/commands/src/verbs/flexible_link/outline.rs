//! What the segments of a flexible link look like: the section, pushed along the segment. Its
//! dimensions are expressions of the section's, so that they follow a change. It weighs nothing: the
//! parts have masses of their own.

use std::fmt::Write;

use super::chain::{Chain, write_marker};

/// What a section is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// By the section's `width` and `height`; a box is drawn by its outer walls.
    Block,
    /// By the section's `diameter`; a tube is drawn by its outer wall.
    Cylinder,
    Ellipse,
    I,
    /// Only properties are known: the block with the same radii of gyration.
    Equivalent,
}

impl Outline {
    /// By the class of the section.
    pub fn of(class: &str) -> Outline {
        match class {
            "section_circle" | "section_tube" => Outline::Cylinder,
            "section_ellipse" => Outline::Ellipse,
            "section_i" => Outline::I,
            "section_rectangle" | "section_box" => Outline::Block,
            _ => Outline::Equivalent,
        }
    }

    /// Writes the geometry of a segment, named as the dialog names objects: by the link, the kind and
    /// the number.
    pub fn write(self, text: &mut String, chain: &Chain, number: usize) {
        let (kind, prefix) = match self {
            Outline::Block | Outline::Equivalent => ("block", "BOX"),
            Outline::Cylinder => ("cylinder", "CYLINDER"),
            Outline::Ellipse | Outline::I => ("extrusion", "EXTRUSION"),
        };
        let part = chain.part(number);
        let own = |what: &str| format!("{part}.{}", model::quoted(&format!("{}_{what}_{number}", chain.name)));
        let (shape, marker) = (own(prefix), own("CORNER"));
        let (section, step) = (&chain.section, chain.step());
        let half = -step / 2.0;
        let [width, height] = match self {
            // b h = A, b h^3 / 12 = Iyy, h b^3 / 12 = Izz, up to one factor for both sides.
            Outline::Equivalent => {
                ["izz", "iyy"].map(|cell| format!("SQRT(12 * {section}.{cell} / {section}.area_of_cross_section)"))
            }
            _ => ["width", "height"].map(|cell| format!("{section}.{cell}")),
        };
        let unit = chain.length_unit;
        let begin = format!("geometry create shape {kind} {kind}_name = {shape}");
        match self {
            Outline::Block | Outline::Equivalent => {
                let _ = writeln!(
                    text,
                    "marker create marker_name = {marker} location = {half:?}, (-0.5 * {width}), (-0.5 * {height}) \
                     orientation = 0, 0, 0 relative_to = {part}\n{begin} corner_marker = {marker} \
                     diag_corner_coords = ({step:?}{unit}), ({width}), ({height})"
                );
            }
            Outline::Cylinder => {
                write_across(text, &marker, &part, half);
                let _ = writeln!(
                    text,
                    "{begin} center_marker = {marker} length = ({step:?}{unit}) radius = (0.5 * {section}.diameter)"
                );
            }
            Outline::Ellipse | Outline::I => {
                write_across(text, &marker, &part, half);
                let corners = if self == Outline::I { i_corners(section) } else { ellipse_corners(&width, &height) };
                let points: Vec<String> = corners.iter().map(|[y, z]| format!("({y}), ({z}), 0.0")).collect();
                let _ = writeln!(
                    text,
                    "{begin} reference_marker = {marker} relative_to = {marker}  &\n   points_for_profile = {}  &\n   \
                     length_along_z_axis = ({step:?}{unit})",
                    points.join(",  &\n      ")
                );
            }
        }
        if let Some(color) = &chain.color {
            let _ = writeln!(text, "geometry attributes geometry_name = {shape} color = {color}");
        }
    }
}

/// A marker whose x, y and z are the part's y, z and x: the plane of the section.
fn write_across(text: &mut String, name: &str, part: &str, x: f64) {
    write_marker(text, name, part, x, "90d, 90d, 0d");
}

/// The corners of an I, closed.
fn i_corners(section: &str) -> Vec<[String; 2]> {
    let y = |sign: f64| format!("{:?} * {section}.width", 0.5 * sign);
    let web = |sign: f64| format!("{:?} * {section}.web_thickness", 0.5 * sign);
    let z = |sign: f64| format!("{:?} * {section}.height", 0.5 * sign);
    let inner = |sign: f64| format!("{:?} * ({section}.height - 2 * {section}.flange_thickness)", 0.5 * sign);
    vec![
        [y(-1.0), z(-1.0)],
        [y(1.0), z(-1.0)],
        [y(1.0), inner(-1.0)],
        [web(1.0), inner(-1.0)],
        [web(1.0), inner(1.0)],
        [y(1.0), inner(1.0)],
        [y(1.0), z(1.0)],
        [y(-1.0), z(1.0)],
        [y(-1.0), inner(1.0)],
        [web(-1.0), inner(1.0)],
        [web(-1.0), inner(-1.0)],
        [y(-1.0), inner(-1.0)],
        [y(-1.0), z(-1.0)],
    ]
}

/// Corners of an ellipse, closed.
fn ellipse_corners(width: &str, height: &str) -> Vec<[String; 2]> {
    const CORNERS: i32 = 24;
    let at = |k: i32| (std::f64::consts::TAU * f64::from(k % CORNERS) / f64::from(CORNERS)).sin_cos();
    (0..=CORNERS)
        .map(|k| {
            let (sine, cosine) = at(k);
            [format!("{:?} * {width}", 0.5 * cosine), format!("{:?} * {height}", 0.5 * sine)]
        })
        .collect()
}
