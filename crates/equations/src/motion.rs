//! From the solver's vectors to the state that elements see.

use glam::{DMat3, DQuat, DVec3};

use crate::layout::{BodySlot, Layout};
use crate::{Body, Frame, FrameMotion, GROUND, State};

pub(crate) fn vec3(values: &[f64], at: usize) -> DVec3 {
    DVec3::new(values[at], values[at + 1], values[at + 2])
}

pub(crate) fn put(vector: DVec3, values: &mut [f64], at: usize) {
    values[at..at + 3].copy_from_slice(&vector.to_array());
}

pub(crate) fn quaternion(q: &[f64], slot: &BodySlot) -> DQuat {
    let at = slot.position + 3;
    DQuat::from_xyzw(q[at + 1], q[at + 2], q[at + 3], q[at])
}

pub(crate) fn put_quaternion(value: DQuat, q: &mut [f64], slot: &BodySlot) {
    let at = slot.position + 3;
    q[at..at + 4].copy_from_slice(&[value.w, value.x, value.y, value.z]);
}

/// A state of the right size with every frame at its initial place.
pub(crate) fn new_state(bodies: &[Body], frames: &[Frame]) -> State {
    let mut state = State {
        time: 0.0,
        bodies: bodies.iter().map(|body| body.initial).collect(),
        rotations: vec![DMat3::IDENTITY; bodies.len()],
        frames: vec![FrameMotion::GLOBAL; frames.len()],
        statics: false,
    };
    for (motion, frame) in state.frames.iter_mut().zip(frames) {
        motion.body = frame.body;
        if frame.body == GROUND {
            motion.r_bi_g = frame.r_bi_b;
            motion.r_gi_g = frame.r_bi_b;
            motion.rot_gi = frame.rot_bi;
        }
    }
    state
}

/// Places bodies and frames.
pub(crate) fn place(state: &mut State, layout: &Layout, bodies: &[Body], frames: &[Frame], q: &[f64]) {
    for (at, slot) in layout.bodies.iter().enumerate() {
        let motion = &mut state.bodies[at];
        motion.r_gb_g = vec3(q, slot.position);
        motion.q_gb = if slot.size == 6 { quaternion(q, slot).normalize() } else { bodies[at].initial.q_gb };
        state.rotations[at] = DMat3::from_quat(motion.q_gb);
    }
    for (motion, frame) in state.frames.iter_mut().zip(frames) {
        if frame.body != GROUND {
            let rot_gb = state.rotations[frame.body.0 as usize];
            motion.r_bi_g = rot_gb * frame.r_bi_b;
            motion.r_gi_g = state.bodies[frame.body.0 as usize].r_gb_g + motion.r_bi_g;
            motion.rot_gi = rot_gb * frame.rot_bi;
        }
    }
}

/// Velocities of bodies and frames; all zero without `v`.
pub(crate) fn set_velocities(state: &mut State, layout: &Layout, v: Option<&[f64]>) {
    for (at, slot) in layout.bodies.iter().enumerate() {
        let motion = &mut state.bodies[at];
        motion.v_gb_g = v.map_or(DVec3::ZERO, |v| vec3(v, slot.velocity));
        motion.w_gb_b = match v {
            Some(v) if slot.size == 6 => vec3(v, slot.velocity + 3),
            _ => DVec3::ZERO,
        };
    }
    for motion in &mut state.frames {
        if motion.body != GROUND {
            let at = motion.body.0 as usize;
            motion.w_gi_g = state.rotations[at] * state.bodies[at].w_gb_b;
            motion.v_gi_g = state.bodies[at].v_gb_g + motion.w_gi_g.cross(motion.r_bi_g);
        }
    }
}

/// Accelerations of bodies and frames; all zero without `a`.
pub(crate) fn set_accelerations(state: &mut State, layout: &Layout, a: Option<&[f64]>) {
    for (at, slot) in layout.bodies.iter().enumerate() {
        let motion = &mut state.bodies[at];
        motion.a_gb_g = a.map_or(DVec3::ZERO, |a| vec3(a, slot.velocity));
        motion.alpha_gb_b = match a {
            Some(a) if slot.size == 6 => vec3(a, slot.velocity + 3),
            _ => DVec3::ZERO,
        };
    }
    for motion in &mut state.frames {
        if motion.body != GROUND {
            let at = motion.body.0 as usize;
            let (w, arm) = (motion.w_gi_g, motion.r_bi_g);
            motion.alpha_gi_g = state.rotations[at] * state.bodies[at].alpha_gb_b;
            motion.a_gi_g = if a.is_some() {
                state.bodies[at].a_gb_g + motion.alpha_gi_g.cross(arm) + w.cross(w.cross(arm))
            } else {
                DVec3::ZERO
            };
        }
    }
}

/// `exp(theta)` as a quaternion.
pub(crate) fn exponential(theta: DVec3) -> DQuat {
    let angle = theta.length();
    // sin(angle/2)/angle; the series is exact to rounding below the switch.
    let factor = if angle < 1e-4 { 0.5 - angle * angle / 48.0 } else { (0.5 * angle).sin() / angle };
    let v = theta * factor;
    DQuat::from_xyzw(v.x, v.y, v.z, (0.5 * angle).cos())
}

/// Rotation vector of a quaternion, of the shorter way round.
pub(crate) fn logarithm(q: DQuat) -> DVec3 {
    let v = DVec3::new(q.x, q.y, q.z) * if q.w < 0.0 { -1.0 } else { 1.0 };
    let (sine, cosine) = (v.length(), q.w.abs());
    if sine < 1e-8 { v * (2.0 / cosine) } else { v * (2.0 * sine.atan2(cosine) / sine) }
}
