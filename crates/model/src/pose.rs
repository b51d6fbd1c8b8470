//! Rotation sequences and where frames are.

use glam::{DMat3, DVec3};

use crate::{CellKey, Database, ObjectId};

/// Origin and axes of a frame, in the parent's or the global frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub origin: DVec3,
    /// Columns are the axes of the frame.
    pub rotation: DMat3,
}

impl Pose {
    pub const GLOBAL: Pose = Pose { origin: DVec3::ZERO, rotation: DMat3::IDENTITY };

    /// The pose of a child given in this frame.
    #[must_use]
    pub fn then(&self, child: &Pose) -> Pose {
        Pose { origin: self.origin + self.rotation * child.origin, rotation: self.rotation * child.rotation }
    }

    #[must_use]
    pub fn inverse(&self) -> Pose {
        let transposed = self.rotation.transpose();
        Pose { origin: -(transposed * self.origin), rotation: transposed }
    }
}

/// One of the 24 rotation sequences: axes 0..2 in order, about body or space axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Sequence {
    pub body: bool,
    pub axes: [u8; 3],
}

impl Sequence {
    pub const BODY_313: Sequence = Sequence { body: true, axes: [2, 0, 2] };

    /// Reads `body313`, `space123`, ...; `None` if it is not one of the 24.
    pub fn named(word: &str) -> Option<Sequence> {
        let word = word.to_ascii_lowercase();
        let (body, digits) = match word.strip_prefix("body") {
            Some(digits) => (true, digits),
            None => (false, word.strip_prefix("space")?),
        };
        let digits: Vec<u8> = digits.bytes().map(|b| b.wrapping_sub(b'1')).collect();
        let axes: [u8; 3] = digits.try_into().ok()?;
        (axes.iter().all(|&a| a < 3) && axes[0] != axes[1] && axes[1] != axes[2]).then_some(Sequence { body, axes })
    }
}

fn about(axis: u8, angle_rad: f64) -> DMat3 {
    match axis {
        0 => DMat3::from_rotation_x(angle_rad),
        1 => DMat3::from_rotation_y(angle_rad),
        _ => DMat3::from_rotation_z(angle_rad),
    }
}

/// Rotation matrix of three angles (radians) in a sequence.
pub fn rotation_of(sequence: Sequence, angles_rad: [f64; 3]) -> DMat3 {
    let [a, b, c] = [0, 1, 2].map(|k| about(sequence.axes[k], angles_rad[k]));
    if sequence.body { a * b * c } else { c * b * a }
}

/// Body 3-1-3 angles (radians) of a rotation; the third angle is 0 where the first and third axis
/// coincide.
pub fn angles_of(rotation: &DMat3) -> [f64; 3] {
    let m = |row: usize, column: usize| rotation.col(column)[row];
    let sine = m(0, 2).hypot(m(1, 2));
    let second = sine.atan2(m(2, 2));
    if sine > 1e-12 {
        [m(0, 2).atan2(-m(1, 2)), second, m(2, 0).atan2(m(2, 1))]
    } else if m(2, 2) > 0.0 {
        [m(1, 0).atan2(m(0, 0)), 0.0, 0.0]
    } else {
        [m(1, 0).atan2(m(0, 0)), std::f64::consts::PI, 0.0]
    }
}

impl Database {
    /// Pose of an object with cells `location` and `orientation` in its parent's frame; lengths in
    /// the current units.
    pub fn local_pose(&self, id: ObjectId) -> Pose {
        let vector = |name| self.triple(id, name);
        let angle = self.units().angle.si;
        Pose {
            origin: vector("location").map_or(DVec3::ZERO, DVec3::from_array),
            rotation: vector("orientation")
                .map_or(DMat3::IDENTITY, |a| rotation_of(Sequence::BODY_313, a.map(|x| x * angle))),
        }
    }

    /// Pose in the global frame; lengths in the current units.
    pub fn global_pose(&self, id: ObjectId) -> Pose {
        let local = self.local_pose(id);
        match self.object(id).parent {
            Some(parent) => self.global_pose(parent).then(&local),
            None => local,
        }
    }

    /// The cells a global pose depends on.
    pub fn pose_reads(&self, id: ObjectId) -> Vec<CellKey> {
        let mut reads = Vec::new();
        let mut next = Some(id);
        while let Some(object) = next {
            for name in ["location", "orientation"] {
                if let Some(cell) = self.object(object).class.cell_index(name) {
                    reads.push(CellKey::new(object, cell));
                }
            }
            next = self.object(object).parent;
        }
        reads
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: body 3-1-3 angles 180, 90, 180 degrees are a turn of -90 degrees about x.
    #[test]
    fn body_313_angles_make_the_documented_rotation() {
        let turn = rotation_of(Sequence::BODY_313, [180.0_f64, 90.0, 180.0].map(f64::to_radians));
        assert!(turn.abs_diff_eq(DMat3::from_rotation_x(-std::f64::consts::FRAC_PI_2), 1e-15));
    }

    #[test]
    fn angles_come_back_from_a_rotation() {
        for angles in [[0.3, 0.8, -1.2], [0.0, 0.0, 0.0], [2.0, std::f64::consts::PI, 0.0], [1.0, 3.0, 2.0]] {
            let rotation = rotation_of(Sequence::BODY_313, angles);
            assert!(rotation_of(Sequence::BODY_313, angles_of(&rotation)).abs_diff_eq(rotation, 1e-14));
        }
    }

    #[test]
    fn only_the_24_sequences_have_names() {
        assert_eq!(Sequence::named("body313"), Some(Sequence::BODY_313));
        assert!(Sequence::named("space123").is_some_and(|s| !s.body));
        assert_eq!(Sequence::named("body113"), None);
        assert_eq!(Sequence::named("313"), None);
    }
}
