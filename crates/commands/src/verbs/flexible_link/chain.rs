//! The commands that make a flexible link.

use std::fmt::Write;

use glam::{DMat3, DVec3};

use super::{outline::Outline, point};
use crate::verbs::section::TAKEN;

/// How an end of a link is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attachment {
    /// The outer part is fixed to the body of the marker.
    Rigid,
    /// A beam of half a segment.
    Flexible,
    Free,
}

/// A link with all it takes to write its commands.
pub struct Chain {
    pub name: String,
    pub model: String,
    pub ground: String,
    /// The bodies of the two markers.
    pub bodies: [String; 2],
    /// Global, in the model's unit.
    pub start: DVec3,
    pub chord: DVec3,
    /// Of the parts, body 3-1-3 in the model's unit.
    pub angles: [f64; 3],
    pub length_unit: &'static str,
    pub length_si: f64,
    pub segments: usize,
    pub attachments: [Attachment; 2],
    pub material: String,
    pub section: String,
    pub damping_ratio: f64,
    pub formulation: String,
    pub color: Option<String>,
    /// `None` for no geometry.
    pub outline: Option<Outline>,
}

/// Axes of the parts: x along the chord, y as near to the y axis of the first marker as may be, or z
/// to its z axis where y is along the chord.
pub fn axes(chord: DVec3, marker: &DMat3) -> DMat3 {
    let x = chord.normalize();
    let across = |v: DVec3| v - x * x.dot(v);
    let y = across(marker.y_axis);
    let y = if y.length() > 1e-6 { y.normalize() } else { across(marker.z_axis).normalize().cross(x) };
    DMat3::from_cols(x, y, x.cross(y))
}

impl Chain {
    /// Length of a segment.
    pub fn step(&self) -> f64 {
        self.chord.length() / self.segments as f64
    }

    pub fn part(&self, number: usize) -> String {
        format!("{}.{}", self.model, model::quoted(&format!("{}_{number}", self.name)))
    }

    /// An object of the model, named as the dialog names all it makes: the link, the kind, the number.
    fn named(&self, kind: &str, number: usize) -> String {
        format!("{}.{}", self.model, self.leaf(kind, number))
    }

    fn leaf(&self, kind: &str, number: usize) -> String {
        model::quoted(&format!("{}_{kind}_{number}", self.name))
    }

    /// The marker at an end of the link, on its outer part.
    fn end(&self, end: usize, outer: usize) -> String {
        format!("{}.{}", self.part(outer), self.leaf("MARKER", end + 1))
    }

    /// The marker that is made on the body of an end.
    fn holder(&self, end: usize) -> String {
        format!("{}.{}", self.bodies[end], self.leaf("MARKER", end + 3))
    }

    pub fn commands(&self) -> String {
        let mut text = String::new();
        for number in 1..=self.segments {
            self.write_part(&mut text, number);
        }
        let mut beams = 0;
        let mut beam = |text: &mut String, i: &str, j: &str, length: f64| {
            beams += 1;
            self.write_beam(text, beams, i, j, length);
        };
        let ends = [1, self.segments];
        for end in [0, 1] {
            self.write_end(&mut text, end, ends[end]);
        }
        let cm = |number: usize| format!("{}.cm", self.part(number));
        if self.attachments[0] == Attachment::Flexible {
            beam(&mut text, &cm(1), &self.holder(0), self.step() / 2.0);
        }
        for number in 2..=self.segments {
            beam(&mut text, &cm(number), &cm(number - 1), self.step());
        }
        if self.attachments[1] == Attachment::Flexible {
            beam(&mut text, &self.holder(1), &cm(self.segments), self.step() / 2.0);
        }
        text
    }

    /// A rigid segment with the marker of its middle.
    fn write_part(&self, text: &mut String, number: usize) {
        let part = self.part(number);
        let middle = self.start + self.chord * ((number as f64 - 0.5) / self.segments as f64);
        let [a, b, c] = self.angles;
        let ground = &self.ground;
        let _ = writeln!(
            text,
            "part create rigid_body name_and_position part_name = {part}  &\n   location = {}  &\n   \
             orientation = {a:?}, {b:?}, {c:?}  &\n   relative_to = {ground}",
            point(middle)
        );
        write_marker(text, &format!("{part}.cm"), &part, 0.0, "0, 0, 0");
        let (density, section) = (format!("{}.density", self.material), &self.section);
        let step = format!("{:?}{}", self.step(), self.length_unit);
        let mass = format!("{density} * {section}.area_of_cross_section * {step}");
        let across = |cell: &str| {
            format!("{density} * {step} * ({section}.{cell} + {section}.area_of_cross_section * {step}**2 / 12)")
        };
        let _ = writeln!(
            text,
            "part create rigid_body mass_properties part_name = {part}  &\n   mass = ({mass})  &\n   \
             center_of_mass_marker = {part}.cm  &\n   ixx = ({density} * {step} * ({section}.iyy + {section}.izz))  &\n   \
             iyy = ({})  &\n   izz = ({})",
            across("iyy"),
            across("izz")
        );
        if let Some(color) = &self.color {
            let _ = writeln!(text, "part attributes part_name = {part} color = {color}");
        }
        if let Some(outline) = self.outline {
            outline.write(text, self, number);
        }
    }

    /// What is at an end: a marker on the outer part, and what holds it.
    fn write_end(&self, text: &mut String, end: usize, outer: usize) {
        let part = self.part(outer);
        let half = self.step() / 2.0;
        let at = if end == 0 { -half } else { half };
        let marker = self.end(end, outer);
        write_marker(text, &marker, &part, at, "0, 0, 0");
        if self.attachments[end] != Attachment::Free {
            write_marker(text, &self.holder(end), &part, at, "0, 0, 0");
        }
        if self.attachments[end] == Attachment::Rigid {
            let joint = self.named("JOINT", end + 1);
            let _ = writeln!(
                text,
                "constraint create joint fixed joint_name = {joint} i_marker_name = {marker} j_marker_name = {}",
                self.holder(end)
            );
        }
    }

    fn write_beam(&self, text: &mut String, number: usize, i: &str, j: &str, length: f64) {
        let name = self.named("BEAM", number);
        let (material, unit) = (&self.material, self.length_unit);
        let _ = write!(
            text,
            "force create element_like beam beam_name = {name}  &\n   i_marker_name = {i} j_marker_name = {j}  &\n   \
             length = ({length:?}{unit})  &\n   youngs_modulus = ({material}.youngs_modulus)  &\n   \
             shear_modulus = ({material}.youngs_modulus / 2 / (1 + {material}.poissons_ratio))  &\n   \
             damping_ratio = {:?} formulation = {}",
            self.damping_ratio, self.formulation
        );
        for cell in TAKEN {
            let _ = write!(text, "  &\n   {cell} = ({}.{cell})", self.section);
        }
        text.push('\n');
    }
}

/// A marker along x of a part, turned from its axes.
pub fn write_marker(text: &mut String, name: &str, part: &str, x: f64, turned: &str) {
    let _ = writeln!(
        text,
        "marker create marker_name = {name} location = {x:?}, 0, 0 orientation = {turned} relative_to = {part}"
    );
}
