//! A solid circle of radius r.
//!
//! (C.1)  A = π r²,  Iyy = Izz = π r⁴/4,  J = π r⁴/2, exact
//!
//! (C.2)  A/As = 10/9 by energy, over straight cuts;  (7 + 6 ν) / (6 (1 + ν)) by Cowper

use std::f64::consts::PI;

use crate::Theory;

#[must_use]
pub fn area(r: f64) -> f64 {
    PI * r * r
}

#[must_use]
pub fn second_moment(r: f64) -> f64 {
    PI * r.powi(4) / 4.0
}

#[must_use]
pub fn torsion(r: f64) -> f64 {
    PI * r.powi(4) / 2.0
}

/// Eq. (C.2).
#[must_use]
pub fn shear(theory: Theory, poisson: f64) -> f64 {
    match theory {
        Theory::None => 0.0,
        Theory::Energy => 10.0 / 9.0,
        Theory::Cowper => (7.0 + 6.0 * poisson) / (6.0 * (1.0 + poisson)),
    }
}
