//! Outlines of which several shapes are made.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

/// Sides of a whole circle where a shape does not say.
const SIDES: f64 = 20.0;

/// The line at a distance around a polygon of two or more corners, round at outer corners. Arcs are
/// polygons with 20 sides to the full turn, as the mass of an exported link tells.
pub(crate) fn round_outline(corners: &[DVec2], radius: f64) -> Vec<DVec2> {
    let n = corners.len();
    let area: f64 = (0..n).map(|k| corners[k].perp_dot(corners[(k + 1) % n])).sum();
    let corners: Vec<DVec2> = if area < 0.0 { corners.iter().rev().copied().collect() } else { corners.to_vec() };
    let mut outline = Vec::new();
    for k in 0..n {
        let (before, here, after) = (corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]);
        let (Some(into), Some(out)) = ((here - before).try_normalize(), (after - here).try_normalize()) else {
            continue;
        };
        let (first, last) = (-into.perp(), -out.perp());
        let turn = into.perp_dot(out).atan2(into.dot(out));
        // There and back again is half a turn outward, whatever the rounding of its sine says.
        let turn = if turn < 1e-9 - PI { -turn } else { turn };
        if turn < 0.0 {
            outline.push(here + (first + last) * (radius / (1.0 + first.dot(last))));
            continue;
        }
        let pieces = (turn / (2.0 * PI) * SIDES).round().max(1.0);
        for piece in 0..=pieces as u32 {
            outline.push(here + DVec2::from_angle(turn * f64::from(piece) / pieces).rotate(first) * radius);
        }
    }
    outline
}

/// Points on an arc about z, from x.
pub(crate) fn arc_points(radius: f64, angle: f64, pieces: usize) -> Vec<DVec3> {
    (0..=pieces)
        .map(|k| {
            let turn = angle * k as f64 / pieces as f64;
            DVec3::new(radius * turn.cos(), radius * turn.sin(), 0.0)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[DVec2]) -> f64 {
        let n = outline.len();
        (0..n).map(|k| outline[k].perp_dot(outline[(k + 1) % n])).sum::<f64>() / 2.0
    }

    /// Truth: polygon area A with perimeter p, offset by r with arcs: A + p r + (area of the arcs),
    /// where the arcs of 20 sides to a turn add 10 sin(18 degrees) r^2.
    #[test]
    fn outlines_have_the_area_of_the_formula() {
        let arcs = 10.0 * 18_f64.to_radians().sin();
        let bar = round_outline(&[DVec2::ZERO, DVec2::new(6.0, 0.0)], 0.25);
        assert!((area(&bar) - (6.0 * 0.5 + arcs * 0.0625)).abs() < 1e-12);
        let square = [DVec2::ZERO, DVec2::new(0.0, 2.0), DVec2::new(2.0, 2.0), DVec2::new(2.0, 0.0)];
        let round = round_outline(&square, 0.1);
        // Four arcs of 5 pieces each.
        assert!((area(&round) - (4.0 + 8.0 * 0.1 + arcs * 0.01)).abs() < 1e-12);
        // An inner corner stays sharp: an L of area 3 and perimeter 8 with five outer corners of 450
        // degrees together, and one inner corner where the offset overlaps a square of r^2.
        let l = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from);
        let round = round_outline(&l, 0.1);
        assert!((area(&round) - (3.0 + 8.0 * 0.1 + 1.25 * arcs * 0.01 - 0.01)).abs() < 1e-12);
    }
}
