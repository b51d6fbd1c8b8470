//! Primitive equations between two frames, with everything a constraint must know about them:
//! value, gradient, curvature, and the acceleration that motion alone produces.
//!
//! Every equation depends on the position of I in J axes and on the orientation of I in J only, so
//! its load is a load between two frames: `F_I = -lambda dPhi/dd`, `T_I = -lambda dPhi/dpsi` in J
//! axes, with the reaction on J made by [`crate::relative`].

use glam::{DMat3, DVec3};
use solver::Evaluation;

use crate::matrix::{Blocks, outer};
use crate::{Axis, FrameMotion, skew};

/// An angle of I relative to J, from entries `R_ab = (axis a of J) . (axis b of I)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angle {
    /// Projected angle about x of J: `atan2(-R23, R33)`; also the first of the angles 1-2-3.
    X,
    /// Second of the body angles 1-2-3: `asin(R13)`.
    Middle,
    /// Last of the body angles 1-2-3: `atan2(-R12, R11)`, about z of I.
    Last,
    /// Angle from x of J to x of I about z of J: `atan2(R21, R11)`.
    Z,
}

/// One scalar equation between frames I and J.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// `(r_I - r_J) . axis of J`: a distance, m.
    Along(Axis),
    /// `(axis of I) . (axis of J)`: the cosine of an angle.
    Dot(Axis, Axis),
    /// An angle, rad, in (-pi, pi].
    Angle(Angle),
}

/// An equation in the neighbourhood of a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terms {
    pub(crate) value: f64,
    /// Derivative with respect to the position of I in J axes; J axes.
    pub(crate) by_d: DVec3,
    /// Derivative with respect to the spin of I relative to J; J axes.
    pub(crate) by_psi: DVec3,
    /// Derivative of `by_psi` with respect to that spin.
    pub(crate) curvature: DMat3,
    /// Second derivative in time without the part of the accelerations.
    pub(crate) gamma: f64,
}

impl Terms {
    /// No equation. (The default 3x3 matrix would be the identity.)
    pub(crate) const ZERO: Terms =
        Terms { value: 0.0, by_d: DVec3::ZERO, by_psi: DVec3::ZERO, curvature: DMat3::ZERO, gamma: 0.0 };

    /// Derivative of the load on I (J axes) for one unit of `-lambda`.
    pub(crate) fn stiffness(&self) -> Blocks {
        [[DMat3::ZERO; 2], [DMat3::ZERO, self.curvature]]
    }

    /// `f(s, c)` of two scalars that depend on orientation only, from the derivatives of `f`:
    /// first `[f_s, f_c]`, second `[f_ss, f_sc, f_cc]`.
    fn chain(value: f64, s: &Terms, c: &Terms, rates: [f64; 2], first: [f64; 2], second: [f64; 3]) -> Terms {
        let [fs, fc] = first;
        let [fss, fsc, fcc] = second;
        let cross = outer(s.by_psi, c.by_psi);
        Terms {
            value,
            by_d: DVec3::ZERO,
            by_psi: s.by_psi * fs + c.by_psi * fc,
            curvature: s.curvature * fs
                + c.curvature * fc
                + outer(s.by_psi, s.by_psi) * fss
                + (cross + cross.transpose()) * fsc
                + outer(c.by_psi, c.by_psi) * fcc,
            gamma: s.gamma * fs
                + c.gamma * fc
                + fss * rates[0] * rates[0]
                + 2.0 * fsc * rates[0] * rates[1]
                + fcc * rates[1] * rates[1],
        }
    }
}

impl Equation {
    /// Name as Adams prints it, and in words.
    pub fn name(self) -> (String, String) {
        match self {
            Equation::Along(axis) => {
                let axis = axis.letter();
                (axis.to_string(), format!("Translation Along {axis}j"))
            }
            Equation::Dot(i, j) => {
                let (i, j) = (i.letter(), j.letter());
                (format!("{i}i.{j}j"), format!("Rotation Between {i}i & {j}j"))
            }
            Equation::Angle(angle) => {
                let (name, words) = match angle {
                    Angle::X => ("B1", "Rotation About Xj"),
                    Angle::Middle => ("B2", "Rotation About Second Axis"),
                    Angle::Last => ("B3", "Rotation About Zi"),
                    Angle::Z => ("Rz", "Rotation About Zj"),
                };
                (name.to_string(), words.to_string())
            }
        }
    }

    pub(crate) fn value(self, i: &FrameMotion, j: &FrameMotion) -> Result<f64, Evaluation> {
        let entry = |a: Axis, b: Axis| j.axis(a).dot(i.axis(b));
        Ok(match self {
            Equation::Along(axis) => j.axis(axis).dot(i.r_gi_g - j.r_gi_g),
            Equation::Dot(of_i, of_j) => entry(of_j, of_i),
            Equation::Angle(angle) => {
                let (sign, (sa, sb), cosine) = angle.entries();
                let sine = sign * entry(sa, sb);
                match cosine {
                    Some((ca, cb)) => angle_of(sine, entry(ca, cb))?,
                    None => sine.clamp(-1.0, 1.0).asin(),
                }
            }
        })
    }

    pub(crate) fn terms(self, i: &FrameMotion, j: &FrameMotion) -> Result<Terms, Evaluation> {
        Ok(match self {
            Equation::Along(axis) => along(axis, i, j),
            Equation::Dot(of_i, of_j) => dot(1.0, of_j, of_i, i, j).0,
            Equation::Angle(angle) => angle.terms(i, j)?,
        })
    }
}

type Entry = (Axis, Axis);

impl Angle {
    /// Sign and entry of the sine, entry of the cosine (none for an arcsine).
    fn entries(self) -> (f64, Entry, Option<Entry>) {
        match self {
            Angle::X => (-1.0, (Axis::Y, Axis::Z), Some((Axis::Z, Axis::Z))),
            Angle::Middle => (1.0, (Axis::X, Axis::Z), None),
            Angle::Last => (-1.0, (Axis::X, Axis::Y), Some((Axis::X, Axis::X))),
            Angle::Z => (1.0, (Axis::Y, Axis::X), Some((Axis::X, Axis::X))),
        }
    }

    fn terms(self, i: &FrameMotion, j: &FrameMotion) -> Result<Terms, Evaluation> {
        let (sign, (sa, sb), cosine) = self.entries();
        let (sine, rate) = dot(sign, sa, sb, i, j);
        if let Some((ca, cb)) = cosine {
            let (cosine, cosine_rate) = dot(1.0, ca, cb, i, j);
            let (s, c) = (sine.value, cosine.value);
            let n = s * s + c * c;
            let bend = 2.0 * s * c / (n * n);
            let second = [-bend, (s * s - c * c) / (n * n), bend];
            let value = angle_of(s, c)?;
            return Ok(Terms::chain(value, &sine, &cosine, [rate, cosine_rate], [c / n, -s / n], second));
        }
        let s = sine.value.clamp(-1.0, 1.0);
        let c = (1.0 - s * s).sqrt();
        if c < 1e-8 {
            return Err(undefined_angle());
        }
        let second = [s / (c * c * c), 0.0, 0.0];
        Ok(Terms::chain(s.asin(), &sine, &Terms::ZERO, [rate, 0.0], [1.0 / c, 0.0], second))
    }
}

fn angle_of(s: f64, c: f64) -> Result<f64, Evaluation> {
    if s.hypot(c) < 1e-8 { Err(undefined_angle()) } else { Ok(s.atan2(c)) }
}

fn undefined_angle() -> Evaluation {
    Evaluation { message: "the driven angle is not defined: the axes it is measured between are perpendicular".into() }
}

/// `u . (r_I - r_J)` with `u` an axis of J.
fn along(axis: Axis, i: &FrameMotion, j: &FrameMotion) -> Terms {
    let (u, d) = (j.axis(axis), i.r_gi_g - j.r_gi_g);
    let rate = i.v_gi_g - j.v_gi_g;
    // u'' and r'' without the part of angular and centre-of-mass accelerations.
    let turning = |w: DVec3, x: DVec3| w.cross(w.cross(x));
    let centripetal = turning(i.w_gi_g, i.r_bi_g) - turning(j.w_gi_g, j.r_bi_g);
    Terms {
        value: u.dot(d),
        by_d: DVec3::AXES[axis.index()],
        by_psi: DVec3::ZERO,
        curvature: DMat3::ZERO,
        gamma: turning(j.w_gi_g, u).dot(d) + 2.0 * j.w_gi_g.cross(u).dot(rate) + u.dot(centripetal),
    }
}

/// `sign * (axis a of J) . (axis b of I)` and its rate.
fn dot(sign: f64, a: Axis, b: Axis, i: &FrameMotion, j: &FrameMotion) -> (Terms, f64) {
    let (of_j, of_i) = (j.axis(a), i.axis(b));
    let (w_i, w_j) = (i.w_gi_g, j.w_gi_g);
    let across = of_i.cross(of_j);
    let to_j = j.rot_gi.transpose();
    let turning = |w: DVec3, x: DVec3| w.cross(w.cross(x));
    let gamma =
        turning(w_i, of_i).dot(of_j) + 2.0 * w_i.cross(of_i).dot(w_j.cross(of_j)) + of_i.dot(turning(w_j, of_j));
    let terms = Terms {
        value: sign * of_i.dot(of_j),
        by_d: DVec3::ZERO,
        by_psi: to_j * across * sign,
        // d(a_j x b_j) for a_j turned by psi: (psi x a) x b = b x (a x psi)
        curvature: skew(to_j * of_j) * skew(to_j * of_i) * sign,
        gamma: sign * gamma,
    };
    (terms, sign * (w_i - w_j).dot(across))
}
