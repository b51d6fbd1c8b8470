//! A round tube of outer radius R and inner radius r, m = r/R.
//!
//! (T.1)  A = π (R² - r²),  Iyy = Izz = π (R⁴ - r⁴)/4,  J = π (R⁴ - r⁴)/2, exact
//!
//! (T.2)  A/As = [7 (1 + m²)² + 20 m²] / (6 (1 + m²)²) by energy
//!
//! (T.3)  A/As = [(7 + 6 ν)(1 + m²)² + (20 + 12 ν) m²] / (6 (1 + ν)(1 + m²)²) by Cowper
//!
//! Straight cuts say little of a tube, whose stress follows the wall. (T.2) is the energy of the exact
//! stresses of a bent tube without Poisson's ratio. It is 2 for a thin tube, and 7/6 for a tube
//! whose bore closes, where (C.2) has 10/9 because it counts the stress along the force alone.

use std::f64::consts::PI;

use crate::Theory;

#[must_use]
pub fn area(outer: f64, inner: f64) -> f64 {
    PI * (outer - inner) * (outer + inner)
}

#[must_use]
pub fn second_moment(outer: f64, inner: f64) -> f64 {
    area(outer, inner) * (outer * outer + inner * inner) / 4.0
}

#[must_use]
pub fn torsion(outer: f64, inner: f64) -> f64 {
    2.0 * second_moment(outer, inner)
}

/// Eqs. (T.2) and (T.3).
#[must_use]
pub fn shear(outer: f64, inner: f64, theory: Theory, poisson: f64) -> f64 {
    let nu = match theory {
        Theory::None => return 0.0,
        Theory::Energy => 0.0,
        Theory::Cowper => poisson,
    };
    let m2 = (inner / outer).powi(2);
    let square = (1.0 + m2).powi(2);
    ((7.0 + 6.0 * nu) * square + (20.0 + 12.0 * nu) * m2) / (6.0 * (1.0 + nu) * square)
}
