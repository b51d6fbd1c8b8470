//! A coil between two points.

use std::f64::consts::TAU;

use glam::DVec3;

/// A helix with straight ends; `diameter` in the unit of the points.
pub fn coil(i: DVec3, j: DVec3, turns: f64, diameter: f64) -> Vec<DVec3> {
    let Some(axis) = (i - j).try_normalize() else { return vec![i, j] };
    let (across, up) = axis.any_orthonormal_pair();
    let pieces = (turns * 16.0) as usize;
    let helix = (0..=pieces).map(|k| {
        let part = k as f64 / pieces as f64;
        let (sine, cosine) = (part * turns * TAU).sin_cos();
        j.lerp(i, 0.1 + 0.8 * part) + (across * cosine + up * sine) * (diameter / 2.0)
    });
    std::iter::once(j).chain(std::iter::once(j.lerp(i, 0.1))).chain(helix).chain([j.lerp(i, 0.9), i]).collect()
}
