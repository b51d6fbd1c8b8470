//! Derivatives of one number with respect to the motion of bodies.
//!
//! A scalar of a few frames is differentiated backwards: first with respect to what each frame
//! does ([`FrameCotangent`]), then with respect to increments and velocities of the frame's body.

use glam::DVec3;
use smallvec::SmallVec;

use crate::{BodyId, FrameMotion, GROUND, State};

/// Derivative of a scalar with respect to one frame's motion, ground axes: `ds = r . dr_gi +
/// phi . dphi + v . dv_gi + w . dw_gi`, where `dphi` is the frame's spin.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct FrameCotangent {
    pub r: DVec3,
    pub phi: DVec3,
    pub v: DVec3,
    pub w: DVec3,
}

/// Sparse derivative of a scalar: for each body twelve numbers, first with respect to its
/// increment `[dr_g | dtheta_b]`, then with respect to its velocity `[v_g | w_b]`.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Gradient {
    entries: SmallVec<[(BodyId, [f64; 12]); 4]>,
}

impl Gradient {
    pub fn new() -> Self {
        Self::default()
    }

    pub fn clear(&mut self) {
        self.entries.clear();
    }

    pub fn entries(&self) -> &[(BodyId, [f64; 12])] {
        &self.entries
    }

    /// Derivative with respect to one body; zero if there is none.
    pub fn of(&self, body: BodyId) -> [f64; 12] {
        self.entries.iter().find(|(owner, _)| *owner == body).map_or([0.0; 12], |(_, values)| *values)
    }

    /// Adds `factor * values`; what concerns ground is dropped.
    pub fn add(&mut self, body: BodyId, factor: f64, values: &[f64; 12]) {
        if body == GROUND {
            return;
        }
        let at = self.entries.iter().position(|(owner, _)| *owner == body).unwrap_or_else(|| {
            self.entries.push((body, [0.0; 12]));
            self.entries.len() - 1
        });
        for (sum, value) in self.entries[at].1.iter_mut().zip(values) {
            *sum += factor * value;
        }
    }

    /// Adds `factor` times another gradient: the chain rule.
    pub fn add_scaled(&mut self, factor: f64, other: &Gradient) {
        for (body, values) in &other.entries {
            self.add(*body, factor, values);
        }
    }

    /// Adds what a scalar gets through one frame.
    ///
    /// With the arm `c` from the centre of mass to the frame and the body's spin `dphi`:
    /// `dr_gi = dr + dphi x c`, `dw_gi = dw + dphi x w`, `dv_gi = dv + dw x c + dphi x (w x c)`.
    pub fn add_frame(&mut self, state: &State, frame: &FrameMotion, s: &FrameCotangent) {
        if frame.body == GROUND {
            return;
        }
        let (c, w) = (frame.r_bi_g, frame.w_gi_g);
        let phi = s.phi + c.cross(s.r) + w.cross(c).cross(s.v) + w.cross(s.w);
        let spin = s.w + c.cross(s.v);
        let to_body = state.rotation(frame.body).transpose();
        let (phi_b, spin_b) = (to_body * phi, to_body * spin);
        let mut values = [0.0; 12];
        for (part, vector) in [s.r, phi_b, s.v, spin_b].into_iter().enumerate() {
            values[3 * part..3 * part + 3].copy_from_slice(&vector.to_array());
        }
        self.add(frame.body, 1.0, &values);
    }
}
