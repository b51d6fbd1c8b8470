//! A rectangular box: w along y, h along z, two webs of thickness s (their faces look along y) and two
//! flanges of thickness t (their faces look along z), sharp corners.
//!
//! (B.1)  A = w h - (w - 2s)(h - 2t),  Iyy = [w h³ - (w - 2s)(h - 2t)³]/12, and Izz alike
//!
//! (B.2)  J = 4 Am² / ∮ ds/thickness + 1/3 ∮ thickness³ ds over the centre lines, Am = (w - s)(h - t)
//!
//! (B.3)  A/As = straight cuts (S.1) plus the flow along the flanges (S.3) by energy
//!
//! (B.4)  A/As = Cowper's thin-walled box, (S.4) with F = 10 [(3 + ν) m + 3 m²]
//!
//! The first term of (B.2) is R. Bredt's (1896), the second is what the walls carry as strips. With
//! walls of a tenth of the width it is 3 per cent below the exact constant (see the tests).

use crate::{Theory, bands, bands::Band, rectangle};

/// w, h, s, t as in the text above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walls {
    pub width: f64,
    pub height: f64,
    pub web: f64,
    pub flange: f64,
}

impl Walls {
    /// The same box seen with y and z exchanged.
    #[must_use]
    pub fn turned(self) -> Walls {
        Walls { width: self.height, height: self.width, web: self.flange, flange: self.web }
    }

    fn inside(self) -> (f64, f64) {
        (self.width - 2.0 * self.web, self.height - 2.0 * self.flange)
    }
}

#[must_use]
pub fn area(walls: Walls) -> f64 {
    let (w, h) = walls.inside();
    walls.width * walls.height - w * h
}

/// About the axis along the width.
#[must_use]
pub fn second_moment(walls: Walls) -> f64 {
    let (w, h) = walls.inside();
    rectangle::second_moment(walls.width, walls.height) - rectangle::second_moment(w, h)
}

/// Eq. (B.2).
#[must_use]
pub fn torsion(walls: Walls) -> f64 {
    let (s, t) = (walls.web, walls.flange);
    let (w, h) = (walls.width - s, walls.height - t);
    let bredt = 4.0 * (w * h).powi(2) / (2.0 * w / t + 2.0 * h / s);
    bredt + 2.0 * (w * t.powi(3) + h * s.powi(3)) / 3.0
}

/// Eqs. (B.3) and (B.4), force along the height.
#[must_use]
pub fn shear(walls: Walls, theory: Theory, poisson: f64) -> f64 {
    match theory {
        Theory::None => 0.0,
        Theory::Energy => {
            let (area, second) = (area(walls), second_moment(walls));
            let (w, h) = walls.inside();
            let cuts =
                [Band { to: h / 2.0, width: 2.0 * walls.web }, Band { to: walls.height / 2.0, width: walls.width }];
            let arm = (walls.height - walls.flange) / 2.0;
            bands::straight_cuts(&cuts, area, second) + bands::along_flanges(area, second, walls.flange, w / 2.0, arm)
        }
        Theory::Cowper => {
            let (b, h) = (walls.width - walls.web, walls.height - walls.flange);
            let (m, n) = (b * walls.flange / (h * walls.web), b / h);
            bands::cowper_thin(m, poisson, 10.0 * n * n * ((3.0 + poisson) * m + 3.0 * m * m))
        }
    }
}
