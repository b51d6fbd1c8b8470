//! The beam among the forces between two markers: when it has a load, and when to doubt it.

use equations::{Concern, Relative};
use glam::DMat3;

use super::physics::{Formulation, Law, Vec6};
use crate::forces::elastic::{self, Elastic, Response};

/// Relative angles above which a linear beam is a poor description, rad (10 degrees).
pub const SMALL_ANGLE: f64 = std::f64::consts::PI / 18.0;
/// Rotation of an end out of the chord above which a nonlinear beam is one, rad (60 degrees).
pub const LARGE_ANGLE: f64 = std::f64::consts::PI / 3.0;

/// Share of its length to which a beam may shrink before it has no direction any more.
const SHORTEST: f64 = 1e-9;

/// A beam between two frames.
pub type Beam = Elastic<Law>;

impl elastic::Law for Law {
    fn response(&self, motion: &Relative) -> Response {
        Law::response(self, motion)
    }

    fn load(&self, motion: &Relative) -> Vec6 {
        Law::load(self, motion)
    }

    fn energy(&self, motion: &Relative) -> f64 {
        Law::energy(self, motion)
    }

    fn dissipation(&self, motion: &Relative) -> f64 {
        Law::dissipation(self, motion)
    }

    fn has_sections(&self) -> bool {
        true
    }

    /// Axes of J; of the chord frame for NONLINEAR.
    fn section_axes(&self, motion: &Relative) -> DMat3 {
        match &self.formulation {
            Formulation::Nonlinear(law) => law.chord_axes(motion),
            Formulation::Linear | Formulation::String => DMat3::IDENTITY,
        }
    }

    fn largest_angle(&self, motion: &Relative) -> f64 {
        Law::largest_angle(self, motion)
    }

    fn trouble(&self, motion: &Relative) -> Option<&'static str> {
        let along_chord = !matches!(self.formulation, Formulation::Linear);
        (along_chord && motion.d_ji_j.length() <= SHORTEST * self.length)
            .then_some("its markers meet: the beam has no direction")
    }

    /// The largest relative angle when it is beyond [`SMALL_ANGLE`], or [`LARGE_ANGLE`] for NONLINEAR.
    fn concern(&self, motion: &Relative) -> Option<Concern> {
        let angle = self.largest_angle(motion);
        let (limit, sentence) = match self.formulation {
            Formulation::Nonlinear(_) => (LARGE_ANGLE, "bent or twisted beyond what one nonlinear beam describes"),
            Formulation::Linear | Formulation::String => {
                (SMALL_ANGLE, "bent or twisted beyond what a linear beam describes")
            }
        };
        let pieces = Some((angle / limit).ceil() as u32);
        (angle > limit).then_some(Concern { sentence, size: angle.to_degrees(), unit: "degrees", pieces })
    }
}

#[cfg(test)]
#[path = "tests/inside.rs"]
mod tests;
