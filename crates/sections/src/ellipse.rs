//! A solid ellipse of half axes p (along y) and q (along z).
//!
//! (E.1)  A = π p q,  Iyy = π p q³/4,  Izz = π q p³/4
//!
//! (E.2)  J = π p³ q³ / (p² + q²), exact (Saint-Venant)
//!
//! (E.3)  A/As = 10/9 by energy, over straight cuts
//!
//! (E.4)  A/As = [(40 + 37 ν) a⁴ + (16 + 10 ν) a² b² + ν b⁴] / (12 (1 + ν) a² (3 a² + b²)) by Cowper,
//!        a the half axis along the force, b the other
//!
//! (E.3) leaves out the stress across the force, which matters where the section is wide: Cowper's
//! value for a circle without Poisson's ratio is 7/6.

use std::f64::consts::PI;

use crate::Theory;

#[must_use]
pub fn area(p: f64, q: f64) -> f64 {
    PI * p * q
}

/// About the axis along p.
#[must_use]
pub fn second_moment(p: f64, q: f64) -> f64 {
    PI * p * q.powi(3) / 4.0
}

/// Eq. (E.2).
#[must_use]
pub fn torsion(p: f64, q: f64) -> f64 {
    PI * (p * q).powi(3) / (p * p + q * q)
}

/// Eqs. (E.3) and (E.4): `a` is the half axis along the force.
#[must_use]
pub fn shear(a: f64, b: f64, theory: Theory, poisson: f64) -> f64 {
    match theory {
        Theory::None => 0.0,
        Theory::Energy => 10.0 / 9.0,
        Theory::Cowper => {
            let (a2, b2) = (a * a, b * b);
            let above = (40.0 + 37.0 * poisson) * a2 * a2 + (16.0 + 10.0 * poisson) * a2 * b2 + poisson * b2 * b2;
            above / (12.0 * (1.0 + poisson) * a2 * (3.0 * a2 + b2))
        }
    }
}
