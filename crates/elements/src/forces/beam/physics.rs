//! The beam as numbers: section data and the motion of I relative to J give the load on I and its
//! derivatives. Equation numbers refer to `docs.md`.

use equations::Relative;
use glam::{DMat3, DVec3};

use super::corotational::Corotational;
pub use crate::forces::angles::{projected_angles, projected_angles_by_rotation};
pub use crate::forces::elastic::Response;

/// Six numbers: translation or force, then rotation or torque, in J axes.
pub type Vec6 = [f64; 6];
/// Row-major 6x6.
pub type Mat6 = [[f64; 6]; 6];

const ZERO: Mat6 = [[0.0; 6]; 6];

/// Which theory turns deformation into load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Formulation {
    /// Linear Timoshenko beam in the axes of J.
    Linear,
    /// As linear, but the axial force acts along the line from J to I.
    String,
    /// Large rotations in a frame that rides on the chord.
    Nonlinear(Corotational),
}

/// How relative rotation becomes three numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Angles {
    /// Angles of projected axes, as the functions AX, AY and AZ measure them (B.2).
    #[default]
    Projected,
    /// Rotation vector (B.3).
    RotationVector,
}

impl Angles {
    /// The three angles of I turned from J, rad.
    pub fn of(self, rot_ji: &DMat3) -> [f64; 3] {
        match self {
            Angles::Projected => projected_angles(rot_ji),
            Angles::RotationVector => rotation_vector(rot_ji).to_array(),
        }
    }
}

/// Section, material and length of an undeformed beam. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Undeformed length along x of J, m.
    pub length: f64,
    /// Area of the cross section, m^2.
    pub area: f64,
    /// Torsion constant, m^4; equal to the polar moment for circular sections only.
    pub ixx: f64,
    /// Second moments of area about y and z of J, m^4.
    pub iyy: f64,
    pub izz: f64,
    /// Young's and shear modulus, Pa.
    pub e: f64,
    pub g: f64,
    /// Area over shear area in y and z; 0 for no shear flexibility.
    pub asy: f64,
    pub asz: f64,
}

/// Shear corrections `Py`, `Pz` (B.5).
pub fn shear_corrections(s: &Section) -> (f64, f64) {
    let of = |i: f64, ratio: f64| {
        if ratio == 0.0 { 0.0 } else { 12.0 * s.e * i * ratio / (s.g * s.area * s.length * s.length) }
    };
    (of(s.izz, s.asy), of(s.iyy, s.asz))
}

/// Stiffness seen by I, in J axes, order x y z a b c (B.4). N/m, N, N m/rad
pub fn stiffness(s: &Section) -> Mat6 {
    let (py, pz) = shear_corrections(s);
    let l = s.length;
    let (bend_y, bend_z) = (s.e * s.izz / (l * (1.0 + py)), s.e * s.iyy / (l * (1.0 + pz)));
    let mut k = ZERO;
    k[0][0] = s.e * s.area / l;
    k[1][1] = 12.0 * bend_y / (l * l);
    k[2][2] = 12.0 * bend_z / (l * l);
    k[3][3] = s.g * s.ixx / l;
    k[4][4] = (4.0 + pz) * bend_z;
    k[5][5] = (4.0 + py) * bend_y;
    (k[1][5], k[5][1]) = (-6.0 * bend_y / l, -6.0 * bend_y / l);
    (k[2][4], k[4][2]) = (6.0 * bend_z / l, 6.0 * bend_z / l);
    k
}

/// Damping proportional to stiffness (B.6); `ratio` in seconds.
pub fn proportional_damping(stiffness: &Mat6, ratio: f64) -> Mat6 {
    stiffness.map(|row| row.map(|x| x * ratio))
}

/// The symmetric matrix of which `terms` is the lower triangle by columns: C11 C21 .. C61, C22 ..
pub fn from_lower_triangle(terms: &[f64; 21]) -> Mat6 {
    let mut matrix = ZERO;
    let places = (0..6).flat_map(|column| (column..6).map(move |row| (row, column)));
    for ((row, column), term) in places.zip(terms) {
        matrix[row][column] = *term;
        matrix[column][row] = *term;
    }
    matrix
}

/// Constants of one beam during a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    pub length: f64,
    /// Stiffness of the undeformed beam.
    pub stiffness: Mat6,
    /// Damping by the relative velocities; NONLINEAR has its proportional damping in its own law.
    pub damping: Mat6,
    pub formulation: Formulation,
    pub angles: Angles,
}

impl Law {
    /// Deformation x y z a b c of the present state (B.1 to B.3).
    pub fn deformation(&self, motion: &Relative) -> Vec6 {
        let [a, b, c] = self.angles.of(&motion.rot_ji);
        let r = motion.d_ji_j;
        [r.x - self.length, r.y, r.z, a, b, c]
    }

    /// Load on I at I, in J axes (B.7).
    pub fn load(&self, motion: &Relative) -> Vec6 {
        let elastic = self.elastic(motion);
        let rate = rates(motion);
        std::array::from_fn(|row| elastic[row] - dot(&self.damping[row], &rate))
    }

    /// Load with its exact derivatives (B.8).
    pub fn response(&self, motion: &Relative) -> Response {
        if let Formulation::Nonlinear(law) = &self.formulation {
            let (mut load, by_position, mut by_velocity) = law.response(motion);
            let rate = rates(motion);
            for ((load, by_velocity), damping) in load.iter_mut().zip(&mut by_velocity).zip(&self.damping) {
                *load -= dot(damping, &rate);
                by_velocity.iter_mut().zip(damping).for_each(|(slope, term)| *slope -= term);
            }
            return Response { load, by_position, by_velocity };
        }
        let by_rotation = match self.angles {
            Angles::Projected => projected_angles_by_rotation(&motion.rot_ji),
            Angles::RotationVector => rotation_vector_by_rotation(&motion.rot_ji),
        };
        let mut by_position = ZERO;
        for (row, out) in by_position.iter_mut().enumerate() {
            let k = &self.stiffness[row];
            for column in 0..3 {
                out[column] = -k[column];
                out[3 + column] = -(0..3).map(|m| k[3 + m] * by_rotation[m][column]).sum::<f64>();
            }
        }
        if self.formulation == Formulation::String {
            self.add_string_stiffness(motion.d_ji_j, &mut by_position);
        }
        Response { load: self.load(motion), by_position, by_velocity: self.damping.map(|row| row.map(|x| -x)) }
    }

    /// Power the damping takes, W.
    pub fn dissipation(&self, motion: &Relative) -> f64 {
        let rate = rates(motion);
        let of_matrix: f64 = (0..6).map(|row| rate[row] * dot(&self.damping[row], &rate)).sum();
        match &self.formulation {
            Formulation::Nonlinear(law) => of_matrix + law.dissipation(motion),
            Formulation::Linear | Formulation::String => of_matrix,
        }
    }

    /// Elastic energy, J. Exact for NONLINEAR and the axial part of STRING; of the matrix for LINEAR,
    /// which has no potential at large rotations.
    pub fn energy(&self, motion: &Relative) -> f64 {
        if let Formulation::Nonlinear(law) = &self.formulation {
            return law.energy(motion);
        }
        let mut q = self.deformation(motion);
        if self.formulation == Formulation::String {
            q[0] = motion.d_ji_j.length() - self.length;
        }
        0.5 * (0..6).map(|row| q[row] * dot(&self.stiffness[row], &q)).sum::<f64>()
    }

    /// The largest of the three relative angles, rad; for NONLINEAR, of the ends in the chord frame.
    pub fn largest_angle(&self, motion: &Relative) -> f64 {
        if let Formulation::Nonlinear(law) = &self.formulation {
            return law.largest_angle(motion);
        }
        self.deformation(motion)[3..].iter().fold(0.0, |largest: f64, angle| largest.max(angle.abs()))
    }

    fn elastic(&self, motion: &Relative) -> Vec6 {
        if let Formulation::Nonlinear(law) = &self.formulation {
            return law.load(motion);
        }
        let q = self.deformation(motion);
        let mut load: Vec6 = std::array::from_fn(|row| -dot(&self.stiffness[row], &q));
        if self.formulation == Formulation::String {
            let r = motion.d_ji_j;
            let chord = r.length().max(f64::MIN_POSITIVE);
            let pull = self.stiffness[0][0] * (chord - self.length);
            load[0] = 0.0;
            for (force, component) in load.iter_mut().zip((r / chord).to_array()) {
                *force -= pull * component;
            }
        }
        load
    }

    /// (B.9): replaces the axial term by that of a string along the chord.
    fn add_string_stiffness(&self, r_ji_j: DVec3, by_position: &mut Mat6) {
        let chord = r_ji_j.length().max(f64::MIN_POSITIVE);
        let n = (r_ji_j / chord).to_array();
        let axial = self.stiffness[0][0];
        let tension_over_length = axial * (chord - self.length) / chord;
        by_position[0][0] += axial;
        for row in 0..3 {
            for column in 0..3 {
                let unit = f64::from(u8::from(row == column));
                by_position[row][column] -=
                    axial * n[row] * n[column] + tension_over_length * (unit - n[row] * n[column]);
            }
        }
    }
}

fn rates(motion: &Relative) -> Vec6 {
    let (v, w) = (motion.v_ji_j, motion.w_ji_j);
    [v.x, v.y, v.z, w.x, w.y, w.z]
}

fn dot(a: &Vec6, b: &Vec6) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Rotation vector of a rotation (B.3), rad; its length is at most pi.
pub fn rotation_vector(rot_ji: &DMat3) -> DVec3 {
    let q = glam::DQuat::from_mat3(rot_ji);
    let (q, v) = if q.w < 0.0 { (-q.w, -q.xyz()) } else { (q.w, q.xyz()) };
    let sine = v.length();
    if sine < 1e-9 { v * (2.0 / q) } else { v * (2.0 * sine.atan2(q) / sine) }
}

/// Derivative of [`rotation_vector`] by a small rotation of I in J axes.
pub fn rotation_vector_by_rotation(rot_ji: &DMat3) -> [[f64; 3]; 3] {
    let t = rotation_vector(rot_ji);
    let square = t.length_squared();
    let factor = if square < 1e-6 {
        1.0 / 12.0 + square / 720.0
    } else {
        let half = 0.5 * square.sqrt();
        (1.0 - half / half.tan()) / square
    };
    let cross = equations::skew(t);
    let m = DMat3::IDENTITY - cross * 0.5 + cross * cross * factor;
    std::array::from_fn(|row| std::array::from_fn(|column| m.col(column)[row]))
}

#[cfg(test)]
#[path = "tests/physics.rs"]
mod tests;
