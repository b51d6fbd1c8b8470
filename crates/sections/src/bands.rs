//! The energy of Jourawski's shear stress in a shape that is made of bands of constant width.

/// A band between two distances from the middle of the section; a mirror image lies on the other
/// side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Band {
    /// Where the band ends, measured along the force; it begins where the band before ends.
    pub to: f64,
    /// Width across the force.
    pub width: f64,
}

/// Shear factor of straight cuts, bands from the middle outwards:
///
/// (S.1)  A/As = A / I² ∫ S(s)² / b(s) ds,  S(s) = ∫ₛ b t dt
///
/// with the shear stress V S / (I b) of Jourawski (Zhuravskii, 1856). Within a band of width b that
/// ends at t, S = P - b s²/2 with P = S(t) + b t²/2, and the integral has the closed form
///
/// (S.2)  ∫ S²/b ds = P² s/b - P s³/3 + b s⁵/20
pub(crate) fn straight_cuts(bands: &[Band], area: f64, second_moment: f64) -> f64 {
    let mut outside = 0.0; // first moment of what lies further out
    let mut sum = 0.0;
    for (k, band) in bands.iter().enumerate().rev() {
        let from = if k == 0 { 0.0 } else { bands[k - 1].to };
        let (b, to) = (band.width, band.to);
        let p = outside + b * to * to / 2.0;
        let primitive = |s: f64| p * p * s / b - p * s.powi(3) / 3.0 + b * s.powi(5) / 20.0;
        sum += primitive(to) - primitive(from);
        outside = p - b * from * from / 2.0;
    }
    2.0 * area * sum / (second_moment * second_moment)
}

/// What the shear flow along four equal flange halves adds: free at one end, `reach` long, with
/// centre lines `arm` from the middle. The stress V s arm / I grows from the free end:
///
/// (S.3)  A / I² · 4 arm² t reach³ / 3
pub(crate) fn along_flanges(area: f64, second_moment: f64, thickness: f64, reach: f64, arm: f64) -> f64 {
    area / (second_moment * second_moment) * 4.0 * arm * arm * thickness * reach.powi(3) / 3.0
}

/// Cowper's shear factor of a thin-walled shape of two webs or one, and two flanges; `m` is the area of
/// the flanges over the area of the webs, `n` the width over the depth between flange centres.
///
/// (S.4)  A/As = [12 + 72 m + 150 m² + 90 m³ + ν (11 + 66 m + 135 m² + 90 m³) + n² F] / (10 (1+ν)(1+3m)²)
pub(crate) fn cowper_thin(m: f64, poisson: f64, flanges: f64) -> f64 {
    let without = 12.0 + 72.0 * m + 150.0 * m * m + 90.0 * m.powi(3);
    let with = 11.0 + 66.0 * m + 135.0 * m * m + 90.0 * m.powi(3);
    (without + poisson * with + flanges) / (10.0 * (1.0 + poisson) * (1.0 + 3.0 * m).powi(2))
}
