//! The torsion constant of a solid section of which only the area and the two second moments are
//! known. It is exact for rectangles and ellipses, which these numbers give away, and Saint-Venant's
//! estimate for other solid sections.

use std::f64::consts::PI;

/// A torsion constant and where it comes from.
pub(super) struct Torsion {
    /// m^4
    pub constant: f64,
    pub source: &'static str,
}

/// `A^4 / (Iyy Izz)` of all ellipses; no section has more.
const ELLIPSE: f64 = 16.0 * PI * PI;
/// The same of all rectangles: b^4 h^4 over b^3 h / 12 times b h^3 / 12.
const RECTANGLE: f64 = 144.0;
/// Below this a section is hollow, open or thin: an equilateral triangle has 108.
const SOLID: f64 = 100.0;
/// How exactly the numbers of a section must be those of a shape: what is left of four digits.
const SAME: f64 = 1e-3;

/// `None` where the numbers are those of no solid section.
pub(super) fn of_solid(area: f64, iyy: f64, izz: f64) -> Option<Torsion> {
    let compact = area.powi(4) / (iyy * izz);
    let is = |shape: f64| (compact / shape - 1.0).abs() < SAME;
    let (constant, source) = if is(RECTANGLE) {
        let sides = [(12.0 * iyy / area).sqrt(), (12.0 * izz / area).sqrt()];
        (rectangle(sides[0].max(sides[1]), sides[0].min(sides[1])), "exact for the rectangle of these values")
    } else if is(ELLIPSE) {
        (area.powi(4) / (4.0 * PI * PI * (iyy + izz)), "exact for the ellipse of these values")
    } else if (SOLID..ELLIPSE).contains(&compact) {
        (area.powi(4) / (40.0 * (iyy + izz)), "Saint-Venant's estimate A^4 / (40 (iyy + izz)) for solid sections")
    } else {
        return None;
    };
    constant.is_finite().then_some(Torsion { constant, source })
}

/// Saint-Venant's series for a rectangle (Timoshenko and Goodier, Theory of Elasticity, article 109).
fn rectangle(long: f64, short: f64) -> f64 {
    let terms = (1..40).step_by(2).map(|n| {
        let n = f64::from(n);
        (n * PI * long / (2.0 * short)).tanh() / n.powi(5)
    });
    long * short.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * short / long * terms.sum::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: 0.1406 a^4 for a square, 0.229 for sides 2 to 1, 0.312 for 10 to 1 (table of Timoshenko and
    /// Goodier); tolerance half a unit of the last digit. An ellipse: pi a^3 b^3 / (a^2 + b^2).
    #[test]
    fn rectangles_and_ellipses_have_the_constants_of_the_books() {
        for (long, factor, digit) in [(1.0, 0.1406, 5e-5), (2.0, 0.229, 5e-4), (10.0, 0.312, 5e-4)] {
            let found = of_solid(long, long / 12.0, long * long * long / 12.0).unwrap();
            assert!((found.constant / long - factor).abs() < digit, "{long}: {}", found.constant);
            assert!(found.source.contains("rectangle"));
        }
        let (a, b) = (2.0_f64, 0.5_f64);
        let found = of_solid(PI * a * b, PI * a * b.powi(3) / 4.0, PI * a.powi(3) * b / 4.0).unwrap();
        assert!((found.constant / (PI * (a * b).powi(3) / (a * a + b * b)) - 1.0).abs() < 1e-12);
    }

    /// Truth: the equilateral triangle has sqrt(3)/80 s^4, of which the estimate is 6 percent off; a box and
    /// an I section are not solid.
    #[test]
    fn other_sections_are_estimated_or_refused() {
        let moment = 3.0_f64.sqrt() / 96.0;
        let found = of_solid(3.0_f64.sqrt() / 4.0, moment, moment).unwrap();
        assert!((found.constant / (3.0_f64.sqrt() / 80.0) - 1.0).abs() < 0.2, "{}", found.constant);
        // IPE 200, cm: A 28.5, 1943 and 142.
        assert!(of_solid(28.5, 1943.0, 142.0).is_none());
        assert!(of_solid(1.0, 1e-6, 1e-6).is_none(), "no section has so little");
    }
}
