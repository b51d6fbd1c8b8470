//! A solid rectangle of sides w (along y) and h (along z).
//!
//! (R.1)  A = w h,  Iyy = w h³/12,  Izz = h w³/12
//!
//! (R.2)  J = a b³/3 · [1 - 192/π⁵ · b/a · Σ tanh(n π a / 2b) / n⁵],  n = 1, 3, 5, ...,  a >= b
//!
//! (R.3)  A/As = 6/5 by energy;  (12 + 11 ν) / (10 (1 + ν)) by Cowper
//!
//! (R.2) is Saint-Venant's series: Timoshenko and Goodier, Theory of Elasticity, art. 109. The factor
//! by energy holds for tall and narrow sections; in a wide flat one the shear stress varies over the
//! width, and the true factor is larger.

use std::f64::consts::PI;

use crate::Theory;

#[must_use]
pub fn area(width: f64, height: f64) -> f64 {
    width * height
}

/// About the axis along the width.
#[must_use]
pub fn second_moment(width: f64, height: f64) -> f64 {
    width * height.powi(3) / 12.0
}

/// Eq. (R.2).
#[must_use]
pub fn torsion(width: f64, height: f64) -> f64 {
    let (a, b) = (width.max(height), width.min(height));
    let ratio = b / a;
    // Behind the 25th term (n = 51) the rest is below 1e-9 of the sum; tanh is 1 there for every
    // ratio, so that the rest is that of the sum of n^-5 over odd n: 31/32 zeta(5).
    let (mut sum, mut of_ones) = (0.0, 0.0);
    for k in (0..60).rev() {
        let n = f64::from(2 * k + 1);
        let weight = n.powi(-5);
        sum += weight * (n * PI / (2.0 * ratio)).tanh();
        of_ones += weight;
    }
    sum += ODD_FIFTH_POWERS - of_ones;
    a * b.powi(3) / 3.0 * (1.0 - 192.0 / PI.powi(5) * ratio * sum)
}

/// Σ n^-5 over odd n = 31/32 ζ(5).
const ODD_FIFTH_POWERS: f64 = 31.0 / 32.0 * 1.036_927_755_143_37;

/// Eq. (R.3), the same along both sides.
#[must_use]
pub fn shear(theory: Theory, poisson: f64) -> f64 {
    match theory {
        Theory::None => 0.0,
        Theory::Energy => 1.2,
        Theory::Cowper => (12.0 + 11.0 * poisson) / (10.0 * (1.0 + poisson)),
    }
}
