//! How near a flexible link comes to the continuous beam: frequencies of n, 2 n and 4 n segments.
//!
//! Truth is the beam of Euler and Bernoulli in two planes, and the rod in torsion and tension. The links
//! of the report have no shear deflection, as the theory; the rotary inertia of their segments lowers
//! their frequencies a little where the link is stout.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use model::ObjectId;

use super::{Attachment, needed, read_material};
use crate::{Interpreter, call::Call, verbs::shared::Outcome};

/// A link by its data in SI.
pub struct Case {
    length: f64,
    segments: usize,
    ends: [Attachment; 2],
    density: f64,
    e: f64,
    nu: f64,
    area: f64,
    ixx: f64,
    iyy: f64,
    izz: f64,
}

impl Case {
    pub fn of(
        interpreter: &mut Interpreter,
        call: &Call,
        length: f64,
        segments: usize,
        ends: [Attachment; 2],
    ) -> Outcome<Case> {
        let material = read_material(interpreter, call)?;
        let section = needed(interpreter, call, "section_name")?;
        let si = |id: ObjectId, cell: &str| interpreter.database.si(id, cell).unwrap_or(0.0);
        Ok(Case {
            length,
            segments,
            ends,
            density: si(material, "density"),
            e: si(material, "youngs_modulus"),
            nu: si(material, "poissons_ratio"),
            area: si(section, "area_of_cross_section"),
            ixx: si(section, "ixx"),
            iyy: si(section, "iyy"),
            izz: si(section, "izz"),
        })
    }

    /// Commands of a link of some number of segments, alone in a model.
    fn commands(&self, segments: usize) -> String {
        let word = |end: Attachment| match end {
            Attachment::Rigid => "rigid",
            Attachment::Flexible => "flexible",
            Attachment::Free => "free",
        };
        let Case { length, density, e, nu, area, ixx, iyy, izz, .. } = self;
        format!(
            "defaults units length = meter angle = rad force = newton mass = kg time = second\n\
             model create model_name = m\n\
             marker create marker_name = .m.ground.a location = 0, 0, 0 orientation = 0, 0, 0\n\
             marker create marker_name = .m.ground.b location = {length:?}, 0, 0 orientation = 0, 0, 0\n\
             material create material_name = .m.steel density = {density:?} youngs_modulus = {e:?} poissons_ratio = {nu:?}\n\
             section create properties section_name = .m.s area_of_cross_section = {area:?} ixx = {ixx:?} \
             iyy = {iyy:?} izz = {izz:?}\n\
             flexible_link create link_name = link marker_1 = .m.ground.a marker_2 = .m.ground.b segments = {segments} geometry = no \
             material_name = .m.steel section_name = .m.s attachment_1 = {} attachment_2 = {}\n",
            word(self.ends[0]),
            word(self.ends[1]),
        )
    }

    /// The lowest modes of the continuous beam: name and frequency in Hz, in ascending order.
    fn theory(&self) -> Vec<(String, f64)> {
        let free = self.ends.iter().filter(|e| **e == Attachment::Free).count();
        let bending = |k: usize| {
            // cos x cosh x = -1 of the cantilever, = +1 of the others.
            let table = if free == 1 {
                [1.875_104_068_711_961, 4.694_091_132_974_175, 7.854_757_438_237_613]
            } else {
                [4.730_040_744_862_704, 7.853_204_624_095_838, 10.995_607_838_001_67]
            };
            let beyond = if free == 1 { k as f64 - 0.5 } else { k as f64 + 0.5 } * PI;
            table.get(k - 1).copied().unwrap_or(beyond)
        };
        let rod = |k: usize| if free == 1 { k as f64 - 0.5 } else { k as f64 } * PI;
        let g = self.e / 2.0 / (1.0 + self.nu);
        let mut found = Vec::new();
        for k in 1..=6 {
            let squared = (bending(k) / self.length).powi(2) / TAU;
            for (axis, second) in [("y", self.iyy), ("z", self.izz)] {
                let frequency = squared * (self.e * second / (self.density * self.area)).sqrt();
                found.push((format!("bending about {axis}, {k}"), frequency));
            }
            let wave = rod(k) / self.length / TAU;
            let twist = (g * self.ixx / (self.density * (self.iyy + self.izz))).sqrt();
            found.push((format!("torsion, {k}"), wave * twist));
            found.push((format!("tension, {k}"), wave * (self.e / self.density).sqrt()));
        }
        found.retain(|(_, f)| f.is_finite() && *f > 0.0);
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        found.truncate(6);
        found
    }
}

/// The listing.
pub fn lines(interpreter: &Interpreter, case: &Case) -> Outcome<Vec<String>> {
    let theory = case.theory();
    let lowest = theory.first().map_or(0.0, |(_, f)| *f);
    let numbers = [1, 2, 4].map(|factor| case.segments * factor);
    let mut columns = Vec::new();
    for segments in numbers {
        let mut found = interpreter.host.natural_frequencies(&case.commands(segments))?;
        // Motions of the whole link have no frequency but the noise of the numbers.
        found.retain(|f| *f > 0.05 * lowest);
        found.sort_by(f64::total_cmp);
        columns.push(found);
    }
    let mut head = format!("{:<20} {:>14}", "mode", "theory (Hz)");
    for segments in numbers {
        let _ = write!(head, " {:>14} {:>10}", format!("n = {segments} (Hz)"), "error");
    }
    head.push_str("      ratio");
    let mut lines = vec!["Flexible link against the beam of Euler and Bernoulli".to_string(), head];
    for (k, (name, exact)) in theory.iter().enumerate() {
        let mut line = format!("{name:<20} {exact:>14.6}");
        let errors: Vec<Option<f64>> = columns.iter().map(|c| c.get(k).map(|f| f / exact - 1.0)).collect();
        for (column, error) in columns.iter().zip(&errors) {
            match (column.get(k), error) {
                (Some(f), Some(error)) => {
                    let _ = write!(line, " {f:>14.6} {error:>10.2e}");
                }
                _ => line.push_str("              -          -"),
            }
        }
        // By how much the error falls when the number of segments doubles for the last time.
        match (errors[1], errors[2]) {
            (Some(coarse), Some(fine)) if fine != 0.0 => {
                let _ = write!(line, " {:>10.2}", coarse / fine);
            }
            _ => line.push_str("          -"),
        }
        lines.push(line);
    }
    lines.push("ratio: error of 2 n over error of 4 n segments; 4 where the error goes with 1/n squared".to_string());
    Ok(lines)
}
