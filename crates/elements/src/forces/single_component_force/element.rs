//! A force or torque of one component whose size is a function of time and state.

use equations::{
    BodyId, Force, FrameId, FrameLoad, Gradient, Loads, ScalarAction, Side, State, Tangent, apply_scalar,
    load_of_reaction, scalar_load, tangent_scalar,
};
use glam::DVec3;
use solver::Evaluation;

use crate::runtime::StateFunction;

pub struct FunctionForce {
    pub name: String,
    pub i: FrameId,
    pub j: FrameId,
    /// Bodies loaded and bodies the function looks at, without ground and duplicates.
    pub bodies: Vec<BodyId>,
    pub action: ScalarAction,
    /// Whether J gets the reaction.
    pub reaction: bool,
    pub function: StateFunction,
}

impl FunctionForce {
    fn finite(&self, state: &State, value: f64) -> Result<f64, Evaluation> {
        let far = self.action != ScalarAction::Line
            || value == 0.0
            || state.frame(self.i).r_gi_g != state.frame(self.j).r_gi_g;
        if value.is_finite() && far {
            return Ok(value);
        }
        let why = if far {
            format!("the function is {value}")
        } else {
            "its markers coincide: the force has no direction".into()
        };
        Err(Evaluation { message: format!("force `{}` at time {} s: {why}", self.name, state.time) })
    }
}

impl Force for FunctionForce {
    fn name(&self) -> &str {
        &self.name
    }

    fn bodies(&self) -> Vec<BodyId> {
        self.bodies.clone()
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        let value = self.finite(state, self.function.value(state))?;
        apply_scalar(state, self.i, self.j, self.action, self.reaction, value, loads);
        Ok(())
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        let mut gradient = Gradient::new();
        let value = self.finite(state, self.function.value_and_gradient(state, &mut gradient))?;
        tangent_scalar(state, self.i, self.j, self.action, self.reaction, value, &gradient, tangent);
        Ok(())
    }

    fn load_at(&self, state: &State, side: Side) -> FrameLoad {
        let value = self.function.value(state);
        let unit = scalar_load(state, self.i, self.j, self.action);
        let (i, j) = (state.frame(self.i), state.frame(self.j));
        let on_i = FrameLoad {
            f_g: j.rot_gi * DVec3::new(unit[0], unit[1], unit[2]) * value,
            t_g: j.rot_gi * DVec3::new(unit[3], unit[4], unit[5]) * value,
        };
        match side {
            Side::I => on_i,
            Side::J if self.reaction => load_of_reaction(i, j, on_i),
            Side::J => FrameLoad::default(),
        }
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        match side {
            Side::I => Some(self.i),
            Side::J => Some(self.j),
        }
    }
}
