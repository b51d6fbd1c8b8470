//! What elements write loads and their derivatives to.

use glam::DVec3;

use crate::layout::Layout;
use crate::{BodyId, FrameId, FrameLoad, GROUND, Loads, State, Tangent};

/// Generalised loads on all bodies: force at the centre of mass in ground axes, torque about it in
/// body axes.
#[derive(Clone, Debug, Default)]
pub(crate) struct BodyLoads {
    pub(crate) loads: Vec<[DVec3; 2]>,
}

impl Loads for BodyLoads {
    fn at_frame(&mut self, state: &State, frame: FrameId, load: FrameLoad) {
        let motion = state.frame(frame);
        self.at_body(state, motion.body, load.f_g, load.t_g + motion.r_bi_g.cross(load.f_g));
    }

    fn at_body(&mut self, state: &State, body: BodyId, f_g: DVec3, t_g: DVec3) {
        if body == GROUND {
            return;
        }
        let at = body.0 as usize;
        let [force, torque] = &mut self.loads[at];
        *force += f_g;
        *torque += state.rotations[at].transpose() * t_g;
    }
}

/// Hands derivatives of loads over as blocks of the Newton matrix.
pub(crate) struct Blocks<'a> {
    pub(crate) layout: &'a Layout,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    pub(crate) add: &'a mut dyn FnMut(usize, usize, &[f64]),
}

impl Tangent for Blocks<'_> {
    fn stiffness(&self) -> f64 {
        self.stiffness
    }

    fn damping(&self) -> f64 {
        self.damping
    }

    fn add(&mut self, row: BodyId, column: BodyId, block: &[[f64; 6]; 6]) {
        if row == GROUND || column == GROUND {
            return;
        }
        let (row, column) = (row.0 as usize, column.0 as usize);
        let (height, width) = (self.layout.bodies[row].size, self.layout.bodies[column].size);
        let mut values = [0.0; 36];
        for (c, values) in values.chunks_exact_mut(height).take(width).enumerate() {
            for (r, value) in values.iter_mut().enumerate() {
                *value = block[r][c];
            }
        }
        (self.add)(row, column, &values[..height * width]);
    }
}
