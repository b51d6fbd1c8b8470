//! The NONLINEAR beam: small strain in a frame that rides on the chord between the two markers, so
//! that displacements and rotations of the whole may be as large as they like. Equation numbers
//! refer to `docs.md`. Node 1 is J, node 2 is I; all vectors are in J axes.
//!
//! The loads derive from a potential and are the same whichever end is called I. As they balance,
//! the load on I alone says everything: the reaction on J is that of any load between two markers.

use equations::Relative;
use glam::{DMat3, DVec3};

use super::{
    dual::{Dual, Scalar},
    physics::{Mat6, Section, Vec6, shear_corrections},
};

type V3<S> = [S; 3];
/// Three columns.
type M3<S> = [V3<S>; 3];

/// Constants of a NONLINEAR beam. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corotational {
    /// Undeformed length, m.
    pub length: f64,
    /// EA, N.
    axial: f64,
    /// G times the torsion constant, over the length, N m.
    torsion: f64,
    /// For bending about y and z: the stiffness that an end's own rotation meets and that the other
    /// end's meets, over the length, N m.
    bending: [[f64; 2]; 2],
    /// Damping over stiffness, s.
    pub damping_ratio: f64,
}

/// Stress resultants that belong to the natural coordinates, or these themselves: elongation of the
/// chord, rotations of the ends out of the chord frame.
#[derive(Clone, Copy)]
struct Natural<S> {
    /// Elongation, m; or axial force, N.
    axial: S,
    /// Rotation vectors of J and I in the chord frame, rad; or moments, N m.
    ends: [V3<S>; 2],
}

/// Where the chord frame is and how the ends are turned in it.
struct Chord<S> {
    length: S,
    /// Axes of the chord frame.
    e: M3<S>,
    /// Rotation vectors of J and I in the chord frame.
    theta: [V3<S>; 2],
    /// How the frame turns about its axis with the nodes (B.14).
    eta: S,
    eta_i: [S; 2],
}

impl Corotational {
    /// A beam without shear deflection (Euler and Bernoulli), or with that of the section.
    pub fn new(s: &Section, with_shear: bool, damping_ratio: f64) -> Corotational {
        let (py, pz) = if with_shear { shear_corrections(s) } else { (0.0, 0.0) };
        let bend = |i: f64, p: f64| {
            let ei = s.e * i / s.length;
            [ei * (4.0 + p) / (1.0 + p), ei * (2.0 - p) / (1.0 + p)]
        };
        Corotational {
            length: s.length,
            axial: s.e * s.area,
            torsion: s.g * s.ixx / s.length,
            bending: [bend(s.iyy, pz), bend(s.izz, py)],
            damping_ratio,
        }
    }

    /// Load on I at I, in J axes (B.15).
    pub fn load(&self, motion: &Relative) -> Vec6 {
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        self.load_of(motion.d_ji_j.to_array(), columns, motion)
    }

    /// Load on I, its derivative by displacement and small rotation of I, and by the velocities.
    pub fn response(&self, motion: &Relative) -> (Vec6, Mat6, Mat6) {
        let d = motion.d_ji_j.to_array();
        let position = std::array::from_fn(|k| Dual { value: d[k], by: unit(k) });
        // A small rotation p turns an axis a into a + p x a.
        let turned = |axis: DVec3| -> V3<Dual> {
            let by = [DVec3::X, DVec3::Y, DVec3::Z].map(|p| p.cross(axis).to_array());
            std::array::from_fn(|k| Dual { value: axis[k], by: [0.0, 0.0, 0.0, by[0][k], by[1][k], by[2][k]] })
        };
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(turned);
        let load = self.load_of(position, columns, motion);
        (load.map(|x| x.value), load.map(|x| x.by), self.by_velocity(motion))
    }

    /// Elastic energy, J (B.12).
    pub fn energy(&self, motion: &Relative) -> f64 {
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        self.energy_of(motion.d_ji_j.to_array(), columns)
    }

    /// The largest rotation of an end out of the chord frame, rad.
    pub fn largest_angle(&self, motion: &Relative) -> f64 {
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        let chord = chord(motion.d_ji_j.to_array(), &columns);
        chord.theta.iter().flatten().fold(0.0, |largest: f64, angle| largest.max(angle.abs()))
    }

    /// Axes of the chord frame in J (B.10).
    pub fn chord_axes(&self, motion: &Relative) -> DMat3 {
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        DMat3::from_cols_array_2d(&chord(motion.d_ji_j.to_array(), &columns).e)
    }

    /// Power that the damping takes, W; not negative.
    pub fn dissipation(&self, motion: &Relative) -> f64 {
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        let chord = chord(motion.d_ji_j.to_array(), &columns);
        let rates = chord.rates(motion.v_ji_j, motion.w_ji_j);
        let resisting = self.linear(&rates);
        let ends = (0..2).map(|n| dot(resisting.ends[n], rates.ends[n])).sum::<f64>();
        self.damping_ratio * (resisting.axial * rates.axial + ends)
    }

    pub(super) fn energy_of<S: Scalar>(&self, d: V3<S>, columns: M3<S>) -> S {
        let chord = chord(d, &columns);
        let strain = self.strain(&chord);
        let [one, two] = chord.theta;
        let twist = two[0] - one[0];
        let mut energy = strain * strain * (0.5 * self.axial * self.length) + twist * twist * (0.5 * self.torsion);
        for k in 0..2 {
            let [own, other] = self.bending[k];
            let (a, b) = (one[k + 1], two[k + 1]);
            energy = energy + (a * a + b * b) * (0.5 * own) + a * b * other;
        }
        energy
    }

    /// Axial strain of a shallow arch, averaged over the element (B.11).
    fn strain<S: Scalar>(&self, chord: &Chord<S>) -> S {
        let mut strain = (chord.length + -self.length) * (1.0 / self.length);
        for k in 1..3 {
            let (a, b) = (chord.theta[0][k], chord.theta[1][k]);
            strain = strain + (a * a * 2.0 - a * b + b * b * 2.0) * (1.0 / 30.0);
        }
        strain
    }

    /// Gradient of the energy by the natural coordinates (B.13).
    fn resultants<S: Scalar>(&self, chord: &Chord<S>) -> Natural<S> {
        let axial = self.strain(chord) * self.axial;
        let mut forces = self.linear(&Natural { axial: S::constant(0.0), ends: chord.theta });
        forces.axial = axial;
        for k in 1..3 {
            let (a, b) = (chord.theta[0][k], chord.theta[1][k]);
            let bow = axial * (self.length / 30.0);
            forces.ends[0][k] = forces.ends[0][k] + bow * (a * 4.0 - b);
            forces.ends[1][k] = forces.ends[1][k] + bow * (b * 4.0 - a);
        }
        forces
    }

    /// The stiffness of the undeformed element by natural coordinates.
    fn linear<S: Scalar>(&self, x: &Natural<S>) -> Natural<S> {
        let [one, two] = x.ends;
        let torque = (two[0] - one[0]) * self.torsion;
        let moment =
            |own: V3<S>, other: V3<S>, k: usize| own[k + 1] * self.bending[k][0] + other[k + 1] * self.bending[k][1];
        Natural {
            axial: x.axial * (self.axial / self.length),
            ends: [
                [-torque, moment(one, two, 0), moment(one, two, 1)],
                [torque, moment(two, one, 0), moment(two, one, 1)],
            ],
        }
    }

    fn load_of<S: Scalar>(&self, d: V3<S>, columns: M3<S>, motion: &Relative) -> [S; 6] {
        let chord = chord(d, &columns);
        let mut forces = self.resultants(&chord);
        if self.damping_ratio != 0.0 {
            let damping = self.linear(&chord.rates(motion.v_ji_j, motion.w_ji_j));
            forces.axial = forces.axial + damping.axial * self.damping_ratio;
            for n in 0..2 {
                for k in 0..3 {
                    forces.ends[n][k] = forces.ends[n][k] + damping.ends[n][k] * self.damping_ratio;
                }
            }
        }
        chord.load_on_i(&forces)
    }

    /// Derivative of the load by the velocities: the damping of each unit velocity.
    fn by_velocity(&self, motion: &Relative) -> Mat6 {
        let mut by_velocity = [[0.0; 6]; 6];
        if self.damping_ratio == 0.0 {
            return by_velocity;
        }
        let columns = [motion.rot_ji.x_axis, motion.rot_ji.y_axis, motion.rot_ji.z_axis].map(|c| c.to_array());
        let chord = chord(motion.d_ji_j.to_array(), &columns);
        for column in 0..6 {
            let u = unit(column);
            let rates: Natural<f64> = chord.rates(DVec3::from_slice(&u[..3]), DVec3::from_slice(&u[3..]));
            let load = chord.load_on_i(&self.linear(&rates));
            for (row, value) in by_velocity.iter_mut().zip(load) {
                row[column] = self.damping_ratio * value;
            }
        }
        by_velocity
    }
}

/// The chord frame: x along the line from J to I, y the mean of the ends' y axes made square to it.
fn chord<S: Scalar>(d: V3<S>, columns: &M3<S>) -> Chord<S> {
    let [_, y_i, _] = *columns;
    let y_j = [0.0, 1.0, 0.0].map(S::constant);
    let length = dot(d, d).sqrt();
    let e1 = d.map(|x| x / length);
    let mean: V3<S> = std::array::from_fn(|k| (y_j[k] + y_i[k]) * 0.5);
    let across = cross(e1, mean);
    let size = dot(across, across).sqrt();
    let e3 = across.map(|x| x / size);
    let e = [e1, cross(e3, e1), e3];
    let in_frame = |vector: V3<S>| e.map(|axis| dot(axis, vector));
    let (q, q_i) = (in_frame(mean), in_frame(y_i));
    // Row n, column m: axis n of the chord frame by axis m of the end.
    let turned_j: M3<S> = e;
    let turned_i: M3<S> = e.map(|axis| columns.map(|column| dot(axis, column)));
    Chord {
        length,
        e,
        theta: [rotation_vector(&turned_j), rotation_vector(&turned_i)],
        eta: q[0] / q[1],
        eta_i: [q_i[0] / q[1], q_i[1] / q[1]],
    }
}

impl<S: Scalar> Chord<S> {
    /// Rates of the natural coordinates when I moves relative to J.
    fn rates(&self, v_ji_j: DVec3, w_ji_j: DVec3) -> Natural<S> {
        let in_frame = |vector: DVec3| {
            let [x, y, z] = vector.to_array();
            self.e.map(|axis| axis[0] * x + axis[1] * y + axis[2] * z)
        };
        let (v, w) = (in_frame(v_ji_j), in_frame(w_ji_j));
        let spin = [
            (self.eta_i[1] * w[0] - self.eta_i[0] * w[1]) * 0.5 - self.eta * v[2] / self.length,
            -v[2] / self.length,
            v[1] / self.length,
        ];
        let out_of_frame = [spin.map(|x| -x), std::array::from_fn(|k| w[k] - spin[k])];
        Natural { axial: v[0], ends: std::array::from_fn(|n| by_spin(self.theta[n], out_of_frame[n], -1.0)) }
    }

    /// Load on I in J axes that balances resultants (B.15).
    fn load_on_i(&self, forces: &Natural<S>) -> [S; 6] {
        let at_j = by_spin(self.theta[0], forces.ends[0], 1.0);
        let at_i = by_spin(self.theta[1], forces.ends[1], 1.0);
        let sum: V3<S> = std::array::from_fn(|k| at_j[k] + at_i[k]);
        let force = [forces.axial, -sum[2] / self.length, (self.eta * sum[0] + sum[1]) / self.length];
        let torque = [at_i[0] - self.eta_i[1] * sum[0] * 0.5, at_i[1] + self.eta_i[0] * sum[0] * 0.5, at_i[2]];
        std::array::from_fn(|k| {
            let (vector, k) = if k < 3 { (force, k) } else { (torque, k - 3) };
            -(self.e[0][k] * vector[0] + self.e[1][k] * vector[1] + self.e[2][k] * vector[2])
        })
    }
}

/// `x + sign t x x / 2 + c t x (t x x)`: with minus, the rate of a rotation vector `t` from a spin; with
/// plus, the transpose of that, which turns the moment on `t` into a moment (B.14).
fn by_spin<S: Scalar>(t: V3<S>, x: V3<S>, sign: f64) -> V3<S> {
    let square = dot(t, t);
    let c = if square.value() < 1e-2 {
        // (1 - (t/2) cot(t/2)) / t^2 by its series; the next term is below 1e-19.
        let series = [1.0 / 12.0, 1.0 / 720.0, 1.0 / 30240.0, 1.0 / 1_209_600.0, 1.0 / 47_900_160.0, 5.284_190_14e-10];
        series.iter().rev().fold(S::constant(0.0), |sum, term| sum * square + *term)
    } else {
        let half = square.sqrt() * 0.5;
        (-(half / half.tan()) + 1.0) / square
    };
    let first = cross(t, x);
    let second = cross(t, first);
    std::array::from_fn(|k| x[k] + first[k] * (0.5 * sign) + second[k] * c)
}

/// The rotation vector of a rotation given by rows, for angles below a half turn.
fn rotation_vector<S: Scalar>(rows: &M3<S>) -> V3<S> {
    let axial = [rows[2][1] - rows[1][2], rows[0][2] - rows[2][0], rows[1][0] - rows[0][1]].map(|twice| twice * 0.5);
    let cosine = (rows[0][0] + rows[1][1] + rows[2][2] + -1.0) * 0.5;
    let square = dot(axial, axial);
    let factor = if square.value() < 1e-4 && cosine.value() > 0.0 {
        // asin(s) / s by its series; the next term is below 1e-26.
        let series = [1.0, 1.0 / 6.0, 3.0 / 40.0, 5.0 / 112.0, 35.0 / 1152.0, 63.0 / 2816.0];
        series.iter().rev().fold(S::constant(0.0), |sum, term| sum * square + *term)
    } else {
        let sine = square.sqrt();
        sine.atan2(cosine) / sine
    };
    axial.map(|x| x * factor)
}

fn unit(k: usize) -> [f64; 6] {
    std::array::from_fn(|n| f64::from(u8::from(n == k)))
}

fn dot<S: Scalar>(a: V3<S>, b: V3<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross<S: Scalar>(a: V3<S>, b: V3<S>) -> V3<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
#[path = "tests/corotational.rs"]
mod tests;
