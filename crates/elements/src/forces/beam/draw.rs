//! The centre line of a beam.

use glam::DVec3;
use model::Pose;

/// The line from J to I as the beam bends: tangent to x of both markers where these point along it,
/// else straight. Lengths in the unit of the poses.
pub fn centre_line(i: &Pose, j: &Pose) -> Vec<DVec3> {
    let span = i.origin - j.origin;
    let (start, end) = (j.rotation.x_axis, i.rotation.x_axis);
    if start.dot(span) <= 0.0 || end.dot(span) <= 0.0 {
        return vec![j.origin, i.origin];
    }
    let length = span.length();
    (0..=8)
        .map(|k| {
            let s = f64::from(k) / 8.0;
            let (a, b) = (s * (1.0 - s) * (1.0 - s) * length, s * s * (s - 1.0) * length);
            j.origin + span * (s * s * (3.0 - 2.0 * s)) + start * a + end * b
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;

    /// Truth: a cubic through two points with slopes +a and -a sags by a L/4 in the middle.
    #[test]
    fn a_bent_beam_is_drawn_bent_and_a_reversed_one_straight() {
        let slope = 0.01;
        let pose = |x: f64, turn: f64| Pose { origin: DVec3::new(x, 0.0, 0.0), rotation: DMat3::from_rotation_z(turn) };
        let line = centre_line(&pose(2.0, -slope), &pose(0.0, slope));
        // The tangents have length L, not L in x: 1e-4 of the sag.
        assert!((line[4].y / (slope * 2.0 / 4.0) - 1.0).abs() < 1e-4);
        assert_eq!((line[0], line[8]), (DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0)));
        assert_eq!(centre_line(&pose(-2.0, 0.0), &pose(0.0, 0.0)).len(), 2);
    }
}
