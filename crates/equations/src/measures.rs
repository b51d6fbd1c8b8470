//! Kinematic measures between frames, with their exact gradients.
//!
//! Arguments follow the users' functions: `DX(i, j, k)` is the position of I from J along x of K;
//! `l` is the frame in which time derivatives are taken. `None` is the global frame. Values in SI.
//! A gradient, where wanted, is **added** to, with respect to increments and velocities.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::{Axis, FrameCotangent, FrameId, FrameMotion, Gradient, State};

type Wanted<'a> = Option<&'a mut Gradient>;

/// DX, DY, DZ: component of `r_i - r_j` along an axis of K.
pub fn displacement(
    state: &State,
    axis: Axis,
    i: FrameId,
    j: Option<FrameId>,
    k: Option<FrameId>,
    gradient: Wanted<'_>,
) -> f64 {
    let (i, j, k) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(k));
    let (u, d) = (k.axis(axis), i.r_gi_g - j.r_gi_g);
    if let Some(gradient) = gradient {
        add_difference(state, gradient, i, j, u);
        gradient.add_frame(state, k, &FrameCotangent { phi: u.cross(d), ..FrameCotangent::default() });
    }
    u.dot(d)
}

/// DM: distance of the origins. Its derivative at distance 0 is taken as 0.
pub fn distance(state: &State, i: FrameId, j: Option<FrameId>, gradient: Wanted<'_>) -> f64 {
    let (i, j) = (state.frame(i), state.frame_or_global(j));
    let d = i.r_gi_g - j.r_gi_g;
    if let Some(gradient) = gradient {
        add_difference(state, gradient, i, j, d.normalize_or_zero());
    }
    d.length()
}

/// VX, VY, VZ: velocity of I relative to J as seen from L, along an axis of K.
pub fn velocity(
    state: &State,
    axis: Axis,
    i: FrameId,
    j: Option<FrameId>,
    k: Option<FrameId>,
    l: Option<FrameId>,
    gradient: Wanted<'_>,
) -> f64 {
    let k = state.frame_or_global(k);
    let (u, v) = (k.axis(axis), relative_velocity(state, i, j, l));
    if let Some(gradient) = gradient {
        add_velocity(state, gradient, i, j, l, u);
        gradient.add_frame(state, k, &FrameCotangent { phi: u.cross(v), ..FrameCotangent::default() });
    }
    u.dot(v)
}

/// VM: magnitude of the velocity of I relative to J as seen from L.
pub fn speed(state: &State, i: FrameId, j: Option<FrameId>, l: Option<FrameId>, gradient: Wanted<'_>) -> f64 {
    let v = relative_velocity(state, i, j, l);
    if let Some(gradient) = gradient {
        add_velocity(state, gradient, i, j, l, v.normalize_or_zero());
    }
    v.length()
}

/// VR: rate of the distance, positive when I and J separate; 0 at distance 0.
pub fn radial_velocity(state: &State, i: FrameId, j: Option<FrameId>, l: Option<FrameId>, gradient: Wanted<'_>) -> f64 {
    let (frame_i, frame_j) = (state.frame(i), state.frame_or_global(j));
    let d = frame_i.r_gi_g - frame_j.r_gi_g;
    let (e, v) = (d.normalize_or_zero(), relative_velocity(state, i, j, l));
    let rate = e.dot(v);
    if let Some(gradient) = gradient {
        add_velocity(state, gradient, i, j, l, e);
        if e != DVec3::ZERO {
            add_difference(state, gradient, frame_i, frame_j, (v - e * rate) / d.length());
        }
    }
    rate
}

/// WX, WY, WZ: component of `w_i - w_j` along an axis of K.
pub fn angular_velocity(
    state: &State,
    axis: Axis,
    i: FrameId,
    j: Option<FrameId>,
    k: Option<FrameId>,
    gradient: Wanted<'_>,
) -> f64 {
    let (i, j, k) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(k));
    let (u, w) = (k.axis(axis), i.w_gi_g - j.w_gi_g);
    if let Some(gradient) = gradient {
        add_spin_rate(state, gradient, i, j, u);
        gradient.add_frame(state, k, &FrameCotangent { phi: u.cross(w), ..FrameCotangent::default() });
    }
    u.dot(w)
}

/// WM: magnitude of `w_i - w_j`.
pub fn angular_speed(state: &State, i: FrameId, j: Option<FrameId>, gradient: Wanted<'_>) -> f64 {
    let (i, j) = (state.frame(i), state.frame_or_global(j));
    let w = i.w_gi_g - j.w_gi_g;
    if let Some(gradient) = gradient {
        add_spin_rate(state, gradient, i, j, w.normalize_or_zero());
    }
    w.length()
}

/// ACCX, ACCY, ACCZ (an axis of K) as a vector in the axes of K; its length is ACCM. The state
/// must have been computed with accelerations.
pub fn acceleration(state: &State, i: FrameId, j: Option<FrameId>, k: Option<FrameId>, l: Option<FrameId>) -> DVec3 {
    let v = relative_velocity(state, i, j, l);
    let (i, j, l) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(l));
    let (d, w) = (i.r_gi_g - j.r_gi_g, l.w_gi_g);
    let a = i.a_gi_g - j.a_gi_g - l.alpha_gi_g.cross(d) - 2.0 * w.cross(v) - w.cross(w.cross(d));
    state.frame_or_global(k).rot_gi.transpose() * a
}

/// WDTX, WDTY, WDTZ (an axis of K) as a vector in the axes of K; its length is WDTM. The state
/// must have been computed with accelerations.
pub fn angular_acceleration(
    state: &State,
    i: FrameId,
    j: Option<FrameId>,
    k: Option<FrameId>,
    l: Option<FrameId>,
) -> DVec3 {
    let (i, j, l) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(l));
    let rate = i.alpha_gi_g - j.alpha_gi_g - l.w_gi_g.cross(i.w_gi_g - j.w_gi_g);
    state.frame_or_global(k).rot_gi.transpose() * rate
}

/// AX, AY, AZ: projected angle of I relative to J about an axis of J, on the branch nearest to
/// `reference`. Where it is undefined it keeps the reference, with derivative 0.
pub fn angle(state: &State, axis: Axis, i: FrameId, j: Option<FrameId>, reference: f64, gradient: Wanted<'_>) -> f64 {
    let (sine, cosine) = match axis {
        Axis::X => (Entry(-1.0, Axis::Y, Axis::Z), Entry(1.0, Axis::Z, Axis::Z)),
        Axis::Y => (Entry(1.0, Axis::X, Axis::Z), Entry(1.0, Axis::Z, Axis::Z)),
        Axis::Z => (Entry(1.0, Axis::Y, Axis::X), Entry(1.0, Axis::X, Axis::X)),
    };
    arctangent(state, i, j, sine, cosine, reference, gradient)
}

/// PSI, THETA, PHI (`which` 0, 1, 2): body angles 3-1-3 of I relative to J; the first and the last
/// on the branch nearest to `reference`. With parallel z axes the last is 0 and the first takes
/// the whole turn.
pub fn angle_313(
    state: &State,
    which: usize,
    i: FrameId,
    j: Option<FrameId>,
    reference: f64,
    gradient: Wanted<'_>,
) -> f64 {
    use Axis::{X, Y, Z};
    let entry = |a: Axis, b: Axis| state.frame_or_global(j).axis(a).dot(state.frame(i).axis(b));
    let tilt = entry(X, Z).hypot(entry(Y, Z));
    if which == 1 {
        let theta = tilt.atan2(entry(Z, Z));
        if tilt > SINGULAR {
            add_entry(state, gradient, i, j, Entry(-1.0, Z, Z), 1.0 / tilt);
        }
        return theta;
    }
    match (which == 0, tilt > SINGULAR) {
        (true, true) => arctangent(state, i, j, Entry(1.0, X, Z), Entry(-1.0, Y, Z), reference, gradient),
        (true, false) => arctangent(state, i, j, Entry(1.0, Y, X), Entry(1.0, X, X), reference, gradient),
        (false, true) => arctangent(state, i, j, Entry(1.0, Z, X), Entry(1.0, Z, Y), reference, gradient),
        (false, false) => nearest(0.0, reference),
    }
}

/// YAW, PITCH, ROLL (`which` 0, 1, 2): body angles 3-2-1 of I relative to J, where PITCH is minus
/// the second angle; the first and the last on the branch nearest to `reference`.
pub fn yaw_pitch_roll(
    state: &State,
    which: usize,
    i: FrameId,
    j: Option<FrameId>,
    reference: f64,
    gradient: Wanted<'_>,
) -> f64 {
    use Axis::{X, Y, Z};
    match which {
        0 => arctangent(state, i, j, Entry(1.0, Y, X), Entry(1.0, X, X), reference, gradient),
        2 => arctangent(state, i, j, Entry(1.0, Z, Y), Entry(1.0, Z, Z), reference, gradient),
        _ => {
            let entry = |a: Axis, b: Axis| state.frame_or_global(j).axis(a).dot(state.frame(i).axis(b));
            let level = entry(X, X).hypot(entry(Y, X));
            if level > SINGULAR {
                add_entry(state, gradient, i, j, Entry(1.0, Z, X), 1.0 / level);
            }
            entry(Z, X).atan2(level)
        }
    }
}

/// INCANG: angle at J between the directions to I and to K, 0 to pi. Its derivative is taken as 0
/// where the three are in line.
pub fn included_angle(state: &State, i: FrameId, j: FrameId, k: FrameId, gradient: Wanted<'_>) -> f64 {
    let (i, j, k) = (state.frame(i), state.frame(j), state.frame(k));
    let (a, b) = (i.r_gi_g - j.r_gi_g, k.r_gi_g - j.r_gi_g);
    let normal = a.cross(b);
    if let Some(gradient) = gradient {
        let n = normal.normalize_or_zero();
        if n != DVec3::ZERO {
            add_difference(state, gradient, i, j, a.cross(n) / a.length_squared());
            add_difference(state, gradient, k, j, n.cross(b) / b.length_squared());
        }
    }
    normal.length().atan2(a.dot(b))
}

/// Below this sine two of three angles cannot be told apart.
const SINGULAR: f64 = 1e-10;

/// `factor * (axis a of J) . (axis b of I)`: an entry of the rotation of I in J.
#[derive(Clone, Copy)]
struct Entry(f64, Axis, Axis);

fn arctangent(
    state: &State,
    i: FrameId,
    j: Option<FrameId>,
    sine: Entry,
    cosine: Entry,
    reference: f64,
    gradient: Wanted<'_>,
) -> f64 {
    let value = |Entry(factor, a, b): Entry| factor * state.frame_or_global(j).axis(a).dot(state.frame(i).axis(b));
    let (s, c) = (value(sine), value(cosine));
    let n = s * s + c * c;
    if n < SINGULAR * SINGULAR {
        return reference;
    }
    if let Some(gradient) = gradient {
        add_entry(state, Some(&mut *gradient), i, j, sine, c / n);
        add_entry(state, Some(gradient), i, j, cosine, -s / n);
    }
    nearest(s.atan2(c), reference)
}

/// The angle plus whole turns, as near to the reference as possible.
pub fn nearest(angle: f64, reference: f64) -> f64 {
    angle + TAU * ((reference - angle) / TAU).round()
}

/// Adds `factor` times the derivative of an entry of the rotation.
fn add_entry(
    state: &State,
    gradient: Wanted<'_>,
    i: FrameId,
    j: Option<FrameId>,
    Entry(sign, a, b): Entry,
    factor: f64,
) {
    let Some(gradient) = gradient else { return };
    let (i, j) = (state.frame(i), state.frame_or_global(j));
    // d(b_i . a_j) = (dphi_i - dphi_j) . (b_i x a_j)
    let phi = i.axis(b).cross(j.axis(a)) * (sign * factor);
    gradient.add_frame(state, i, &FrameCotangent { phi, ..FrameCotangent::default() });
    gradient.add_frame(state, j, &FrameCotangent { phi: -phi, ..FrameCotangent::default() });
}

/// Adds the derivative of `u . (r_i - r_j)` for constant `u`.
fn add_difference(state: &State, gradient: &mut Gradient, i: &FrameMotion, j: &FrameMotion, u: DVec3) {
    gradient.add_frame(state, i, &FrameCotangent { r: u, ..FrameCotangent::default() });
    gradient.add_frame(state, j, &FrameCotangent { r: -u, ..FrameCotangent::default() });
}

/// Adds the derivative of `u . (w_i - w_j)` for constant `u`.
fn add_spin_rate(state: &State, gradient: &mut Gradient, i: &FrameMotion, j: &FrameMotion, u: DVec3) {
    gradient.add_frame(state, i, &FrameCotangent { w: u, ..FrameCotangent::default() });
    gradient.add_frame(state, j, &FrameCotangent { w: -u, ..FrameCotangent::default() });
}

/// Velocity of I relative to J as seen from L, ground axes.
fn relative_velocity(state: &State, i: FrameId, j: Option<FrameId>, l: Option<FrameId>) -> DVec3 {
    let (i, j, l) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(l));
    i.v_gi_g - j.v_gi_g - l.w_gi_g.cross(i.r_gi_g - j.r_gi_g)
}

/// Adds the derivative of `u . (v_i - v_j - w_l x (r_i - r_j))` for constant `u`.
fn add_velocity(state: &State, gradient: &mut Gradient, i: FrameId, j: Option<FrameId>, l: Option<FrameId>, u: DVec3) {
    let (i, j, l) = (state.frame(i), state.frame_or_global(j), state.frame_or_global(l));
    let (d, r) = (i.r_gi_g - j.r_gi_g, l.w_gi_g.cross(u));
    gradient.add_frame(state, i, &FrameCotangent { v: u, r, ..FrameCotangent::default() });
    gradient.add_frame(state, j, &FrameCotangent { v: -u, r: -r, ..FrameCotangent::default() });
    gradient.add_frame(state, l, &FrameCotangent { w: u.cross(d), ..FrameCotangent::default() });
}
