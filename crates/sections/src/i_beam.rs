//! An I of two equal flanges, w wide (along y) and t thick, and a web of thickness s; h over all (along
//! z), no fillets.
//!
//! (I.1)  A = 2 w t + s c with c = h - 2t,  Iyy = [w h³ - (w - s) c³]/12,  Izz = [2 t w³ + c s³]/12
//!
//! (I.2)  J = 2 w t³ [1/3 - 0.21 t/w (1 - t⁴/(12 w⁴))] + c s³/3 + 2 · 0.15 min(s,t)/max(s,t) · D⁴
//!
//! (I.3)  D = t + s²/(4 t), the circle that fits into a junction
//!
//! (I.4)  A/As along z = straight cuts (S.1) plus the flow along the flanges (S.3) by energy
//!
//! (I.5)  A/As along z = Cowper's thin-walled I, (S.4) with F = 30 (m + m²) + 5 ν (8 m + 9 m²)
//!
//! (I.6)  A/As along y = straight cuts (S.1), by either theory: Cowper has no formula for it
//!
//! (I.2) is the sum of thirds, corrected for the ends of the flanges and for the junctions, as in
//! Young and Budynas, Roark's Formulas for Stress and Strain, table of torsion constants; without
//! fillets. It fits thin walls (s < 2t); warping that is hindered is not in it.

use crate::{Axis, Theory, bands, bands::Band};

/// w, h, s, t as in the text above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walls {
    pub width: f64,
    pub height: f64,
    pub web: f64,
    pub flange: f64,
}

impl Walls {
    fn clear(self) -> f64 {
        self.height - 2.0 * self.flange
    }
}

#[must_use]
pub fn area(walls: Walls) -> f64 {
    2.0 * walls.width * walls.flange + walls.web * walls.clear()
}

/// About the axis along y, or z.
#[must_use]
pub fn second_moment(walls: Walls, about: Axis) -> f64 {
    let Walls { width, height, web, flange } = walls;
    let clear = walls.clear();
    match about {
        Axis::Y => (width * height.powi(3) - (width - web) * clear.powi(3)) / 12.0,
        Axis::Z => (2.0 * flange * width.powi(3) + clear * web.powi(3)) / 12.0,
    }
}

/// Eq. (I.2).
#[must_use]
pub fn torsion(walls: Walls) -> f64 {
    let Walls { width: w, web: s, flange: t, .. } = walls;
    let flange = w * t.powi(3) * (1.0 / 3.0 - 0.21 * t / w * (1.0 - (t / w).powi(4) / 12.0));
    let web = walls.clear() * s.powi(3) / 3.0;
    let circle = t + s * s / (4.0 * t);
    2.0 * flange + web + 2.0 * 0.15 * s.min(t) / s.max(t) * circle.powi(4)
}

/// Eqs. (I.4) to (I.6).
#[must_use]
pub fn shear(walls: Walls, along: Axis, theory: Theory, poisson: f64) -> f64 {
    let Walls { width, height, web, flange } = walls;
    let area = area(walls);
    match (theory, along) {
        (Theory::None, _) => 0.0,
        (_, Axis::Y) => {
            let cuts = [Band { to: web / 2.0, width: height }, Band { to: width / 2.0, width: 2.0 * flange }];
            bands::straight_cuts(&cuts, area, second_moment(walls, Axis::Z))
        }
        (Theory::Energy, Axis::Z) => {
            let second = second_moment(walls, Axis::Y);
            let cuts = [Band { to: walls.clear() / 2.0, width: web }, Band { to: height / 2.0, width }];
            let (reach, arm) = ((width - web) / 2.0, (height - flange) / 2.0);
            bands::straight_cuts(&cuts, area, second) + bands::along_flanges(area, second, flange, reach, arm)
        }
        (Theory::Cowper, Axis::Z) => {
            let h = height - flange;
            let (m, n) = (2.0 * width * flange / (h * web), width / h);
            let f = 30.0 * (m + m * m) + 5.0 * poisson * (8.0 * m + 9.0 * m * m);
            bands::cowper_thin(m, poisson, n * n * f)
        }
    }
}
