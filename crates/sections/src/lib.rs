//! Cross sections of beams: what a beam wants to know of a shape. Pure functions of lengths; any unit
//! of length will do, areas come in its square and second moments in its fourth power.
//!
//! The section lies in the plane of y and z of the beam's J marker, x along the beam. Every shape
//! here is symmetric about both axes, and its centroid is the origin. Widths are along y, heights
//! along z.
//!
//! Numbered equations stand in the file of each shape. What they are for:
//!
//! - `area` A = ∫ dA
//! - `iyy` = ∫ z² dA and `izz` = ∫ y² dA, second moments of area
//! - `ixx`, the torsion constant J of Saint-Venant: torque = G J twist per length. It is `iyy + izz`
//!   for circles and tubes only.
//! - `asy`, `asz`, the shear factors A/As along y and z, 1 or above. 0 stands for no shear
//!   deflection.
//!
//! Shear factors come from one of two theories, see [`Theory`].

mod bands;
pub mod boxed;
pub mod circle;
pub mod ellipse;
pub mod i_beam;
mod marks;
mod outline;
pub mod rectangle;
mod shape;
pub mod tube;

pub use marks::{Mark, Side};
pub use shape::{Note, Properties, Shape};

/// Where shear factors are taken from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theory {
    /// No shear deflection: both factors are 0 (Euler and Bernoulli).
    None,
    /// The shear that does the same work as the stresses which balance the bending stresses: Jourawski's
    /// over straight cuts, and along the flanges of thin-walled shapes; free of Poisson's ratio. 6/5 for
    /// the rectangle, 10/9 for the circle.
    #[default]
    Energy,
    /// G. R. Cowper, "The shear coefficient in Timoshenko's beam theory", Journal of Applied Mechanics
    /// 33 (1966) 335-340; depends on Poisson's ratio.
    Cowper,
}

impl Theory {
    /// The words for the theories, in the order of the variants.
    pub const WORDS: [&'static str; 3] = ["none", "energy", "cowper"];

    /// The theory of a word, ignoring case.
    #[must_use]
    pub fn named(word: &str) -> Option<Theory> {
        let all = [Theory::None, Theory::Energy, Theory::Cowper];
        Self::WORDS.iter().position(|w| w.eq_ignore_ascii_case(word.trim())).map(|i| all[i])
    }
}

/// An axis of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    Y,
    Z,
}
