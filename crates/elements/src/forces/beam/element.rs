//! The beam among the equations: its load on two bodies and the derivative of it.

use equations::{
    BodyId, Concern, Force, FrameId, FrameLoad, Loads, Relative, Side, State, Tangent, apply_between, load_of_reaction,
    relative, tangent_between,
};
use glam::DVec3;
use solver::Evaluation;

use super::physics::{Formulation, Law};

/// Relative angles above which a linear beam is a poor description, rad (10 degrees).
pub const SMALL_ANGLE: f64 = std::f64::consts::PI / 18.0;
/// Rotation of an end out of the chord above which a nonlinear beam is one, rad (60 degrees).
pub const LARGE_ANGLE: f64 = std::f64::consts::PI / 3.0;

/// Share of its length to which a beam may shrink before it has no direction any more.
const SHORTEST: f64 = 1e-9;

/// A beam between two frames.
#[derive(Clone, Debug)]
pub struct Beam {
    pub name: String,
    pub i: FrameId,
    pub j: FrameId,
    /// Bodies of the two frames.
    pub bodies: [BodyId; 2],
    pub law: Law,
}

impl Beam {
    /// Motion of I relative to J, if the beam has a direction.
    fn motion(&self, state: &State) -> Result<Relative, Evaluation> {
        let motion = relative(state, self.i, self.j);
        let chord = motion.d_ji_j.length();
        if matches!(self.law.formulation, Formulation::Linear) || chord > SHORTEST * self.law.length {
            return Ok(motion);
        }
        Err(Evaluation { message: format!("the markers of beam `{}` meet: it has no direction", self.name) })
    }
}

impl Force for Beam {
    fn name(&self) -> &str {
        &self.name
    }

    fn bodies(&self) -> Vec<BodyId> {
        crate::lower::distinct_bodies(&self.bodies)
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        let motion = self.motion(state)?;
        let load = self.law.load(&motion);
        apply_between(state, self.i, self.j, &load, loads);
        Ok(())
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        let response = self.law.response(&self.motion(state)?);
        let (by_position, by_velocity) = (&response.by_position, &response.by_velocity);
        tangent_between(state, self.i, self.j, &response.load, by_position, by_velocity, tangent);
        Ok(())
    }

    fn load_at(&self, state: &State, side: Side) -> FrameLoad {
        let load = self.law.load(&relative(state, self.i, self.j));
        let (i, j) = (state.frame(self.i), state.frame(self.j));
        let on_i = FrameLoad {
            f_g: j.rot_gi * DVec3::new(load[0], load[1], load[2]),
            t_g: j.rot_gi * DVec3::new(load[3], load[4], load[5]),
        };
        match side {
            Side::I => on_i,
            Side::J => load_of_reaction(i, j, on_i),
        }
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        Some(match side {
            Side::I => self.i,
            Side::J => self.j,
        })
    }

    fn energy(&self, state: &State) -> f64 {
        self.law.energy(&relative(state, self.i, self.j))
    }

    /// The largest relative angle when it is beyond [`SMALL_ANGLE`], or [`LARGE_ANGLE`] for NONLINEAR.
    fn concern(&self, state: &State) -> Option<Concern> {
        let angle = self.law.largest_angle(&relative(state, self.i, self.j));
        let (limit, sentence) = match self.law.formulation {
            Formulation::Nonlinear(_) => (LARGE_ANGLE, "bent or twisted beyond what one nonlinear beam describes"),
            Formulation::Linear | Formulation::String => {
                (SMALL_ANGLE, "bent or twisted beyond what a linear beam describes")
            }
        };
        (angle > limit).then_some(Concern { sentence, size: angle.to_degrees(), unit: "degrees" })
    }
}
